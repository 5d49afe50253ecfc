// A program of one's own around frit: runs a case that it holds as text and prints how the powder densifies.
#include <cstdio>

#include "config/case_reader.hpp"
#include "core/error.hpp"
#include "run/run_case.hpp"

namespace {

constexpr const char* powder = R"(
[packing]
generate = "simple-cubic"
count = 64
[cell]
kind = "periodic"
[material]
use = "copper"
[stop]
relative_density = 0.60
)";

class Printer : public frit::run::RunListener {
 public:
  void row_written(const frit::run::RowView& view) override {
    std::printf("%.6g s  %.4f\n", view.state.time, frit::observe::value_of(view.row, "relative_density"));
  }
};

}  // namespace

int main() {
  try {
    Printer printer;
    return frit::run::run_case(frit::config::parse_case(powder, "powder.toml"), {&printer}).code;
  } catch (const frit::InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
