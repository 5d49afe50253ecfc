#include "analyze/centres.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "analyze/same_particles.hpp"
#include "analyze/snapshots.hpp"
#include "core/error.hpp"
#include "io/contacts_csv.hpp"
#include "io/frame_files.hpp"
#include "observe/statistics.hpp"

namespace frit::analyze {
namespace {

using Faults = std::vector<std::string>;

Faults faults_of_counts(const Centres& centres) {
  Faults faults;
  const auto check = [&](const char* option, std::size_t count) {
    if (count == 0 || count == centres.files.size()) return;
    faults.push_back(fmt::format("{}: {} given for {} files of --centres; allowed: one for each, or none",
                                 option, count, centres.files.size()));
  };
  if (centres.files.size() < 2) faults.emplace_back("--centres: needs the files of at least two times");
  check("--contacts", centres.contacts.size());
  check("--times", centres.times.size());
  if (!std::is_sorted(centres.times.begin(), centres.times.end()))
    faults.emplace_back("--times: must ascend");
  return faults;
}

double mean_radius(const Particles& particles) {
  const double sum = std::accumulate(particles.radius.begin(), particles.radius.end(), 0.0);
  return sum / static_cast<double>(particles.size());
}

Image nearest_image(const State& state, std::int32_t i, std::int32_t j) {
  Image image{0, 0, 0};
  const auto& position = state.particles.position;
  for (std::size_t axis = 0; axis < 3 && state.cell.periodic; ++axis) {
    image[axis] = static_cast<std::int8_t>(
        -std::lround((position[j][axis] - position[i][axis]) / state.cell.size[axis]));
  }
  return image;
}

// The table names rows of the file; the state is in the order of the ids.
void use_contacts(const std::filesystem::path& path, const io::Frame& frame, Moment& moment) {
  const io::ContactTable table = io::read_contacts_csv(path, frame.size());
  const auto row_of = [&](std::int32_t file_row) {
    const auto& ids = moment.state.particles.id;
    return static_cast<std::int32_t>(std::ranges::lower_bound(ids, frame.ids[file_row]) - ids.begin());
  };
  std::vector<std::pair<neighbor::Pair, double>> necks;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const std::int32_t one = row_of(table.i[k]), other = row_of(table.j[k]);
    const std::int32_t low = std::min(one, other), high = std::max(one, other);
    necks.push_back({{low, high, nearest_image(moment.state, low, high)},
                     table.neck_radius.empty() ? observe::no_value : table.neck_radius[k]});
  }
  std::ranges::sort(necks, {}, [](const auto& neck) { return std::pair(neck.first.i, neck.first.j); });
  std::vector<neighbor::Pair> pairs;
  for (const auto& [pair, neck_radius] : necks) {
    pairs.push_back(pair);
    if (!table.neck_radius.empty()) moment.necks.neck_radius.push_back(neck_radius);
  }
  set_contacts(moment.state, pairs);
}

Moment read_one(const Centres& centres, std::size_t n) {
  const io::Frame frame = io::read_frame(centres.files[n]);
  Moment moment{centres.files[n].string(), state_of(frame), {}};
  State& state = moment.state;
  state.time = centres.times.empty() ? observe::no_value : centres.times[n];
  if (centres.contacts.empty()) {
    const double gap = centres.gap * mean_radius(state.particles);
    set_contacts(state, neighbor::find_pairs(state.particles, state.cell, gap));
  } else {
    use_contacts(centres.contacts[n], frame, moment);
  }
  return moment;
}

}  // namespace

std::vector<Moment> read_centres(const Centres& centres) {
  Faults faults = faults_of_counts(centres);
  if (!faults.empty()) throw InputError(faults);
  std::vector<Moment> moments;
  for (std::size_t n = 0; n < centres.files.size(); ++n) {
    try {
      moments.push_back(read_one(centres, n));
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(faults);
  if (centres.common_only) keep_common_particles(moments);
  for (std::size_t n = 1; n < moments.size(); ++n) {
    for (std::string& fault : differences_of_ids(moments.front(), moments[n]))
      faults.push_back(std::move(fault));
  }
  if (!faults.empty()) {
    faults.emplace_back("--common leaves out particles that are not in every file");
    throw InputError(faults);
  }
  renumber(moments);
  return moments;
}

}  // namespace frit::analyze
