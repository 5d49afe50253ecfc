#include "run/density_fit.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace frit::run {
namespace {

constexpr int most_trials = 8;
// A trial keeps this share of the bracket from its ends, so that it shrinks from both sides.
constexpr double edge_share = 1e-3;

// Regula falsi after Illinois: an end that stays twice in a row loses half of its weight.
class Bracket {
 public:
  struct End {
    double duration, miss;  // [s], density beyond the target
  };
  Bracket(const End& below, const End& above) : below_(below), above_(above) {}

  double next() const {
    const double share = std::clamp(below_.miss / (below_.miss - above_.miss), edge_share, 1.0 - edge_share);
    return below_.duration + share * (above_.duration - below_.duration);
  }
  void replace_below(const End& end) {
    below_ = end;
    if (last_ == Last::below) above_.miss *= 0.5;
    last_ = Last::below;
  }
  void replace_above(const End& end) {
    above_ = end;
    if (last_ == Last::above) below_.miss *= 0.5;
    last_ = Last::above;
  }

 private:
  enum class Last { none, below, above };
  End below_, above_;
  Last last_ = Last::none;
};

}  // namespace

bool fit_density(const Attempt& attempt, const FitRange& range, Landing& landing) {
  Bracket bracket({0.0, range.start_density - range.target},
                  {landing.report.duration, landing.density - range.target});
  landing.state = {};  // its memory, before the trials take as much
  std::optional<Landing> before;
  for (int trial = 0; trial < most_trials; ++trial) {
    Landing tried;
    if (!attempt(bracket.next(), tried)) break;
    const double miss = tried.density - range.target;
    if (std::abs(miss) <= density_tolerance * range.target) {
      landing = std::move(tried);
      return true;
    }
    if (miss > 0.0) {
      bracket.replace_above({tried.report.duration, miss});
    } else {
      bracket.replace_below({tried.report.duration, miss});
      before = std::move(tried);
    }
  }
  if (!before) return false;
  landing = std::move(*before);
  return true;
}

}  // namespace frit::run
