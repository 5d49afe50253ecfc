#include "report/packing_data.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>

#include "core/error.hpp"
#include "report/distributions.hpp"
#include "report/frame_packer.hpp"

namespace frit::report {
namespace {

using nlohmann::json;

constexpr std::size_t most_histograms = 60;  // snapshots that are read
// Bytes of base64 that a particle and a neck need in a frame, measured on copper powder.
constexpr double bytes_per_particle = 15.0, bytes_per_neck = 3.3;

io::Frame read_particles(const std::filesystem::path& path) {
  io::Frame frame = io::read_vtp_frame(path);
  if (!std::ranges::is_sorted(frame.ids))
    throw InputError(path.string() + ": ids are not in ascending order");
  return frame;
}

// What is learnt from reading each snapshot once.
class Survey {
 public:
  void add(const SnapshotFiles& files) {
    const io::Frame frame = read_particles(files.particles);
    if (frames_ == 0) {
      ids_ = frame.ids;
      mean_radius_ = mean_radius(frame);
    }
    if (frame.ids != ids_)
      throw InputError(files.particles.string() + ": holds other particles than the first snapshot");
    largest_radius_ = std::max(largest_radius_, *std::ranges::max_element(frame.radii));
    add_arrays(frame.arrays, "particles");
    if (!files.contacts.empty()) {
      const io::PolyData network = io::read_vtp(files.contacts);
      most_necks_ = std::max(most_necks_, network.cell_count());
      add_arrays(network.cell_arrays, "contacts");
    }
    ++frames_;
  }

  std::vector<FieldScale> fields() const {
    std::vector<FieldScale> fields;
    for (const auto& [name, of] : quantities_) {
      if (of.over != "particles" || of.range.is_empty()) continue;
      const bool square = of.range.least >= 0.0 && !of.whole;
      fields.push_back({name, square ? 0.0 : of.range.least, of.range.most, square});
    }
    return fields;
  }

  json distributions() const {
    json list = json::array();
    for (const auto& [name, of] : quantities_) {
      if (!of.distribution.is_empty()) list.push_back(of.distribution.to_json());
    }
    return list;
  }

  const std::vector<std::int64_t>& ids() const { return ids_; }
  std::size_t most_necks() const { return most_necks_; }
  double largest_radius() const { return largest_radius_; }
  double mean_radius_at_start() const { return mean_radius_; }

 private:
  struct Quantity {
    std::string over;
    Distribution distribution;
    ValueRange range = ValueRange::none();
    bool whole = true;
  };

  void add_arrays(const std::vector<io::NamedArray>& arrays, const char* over) {
    for (const io::NamedArray& array : arrays) {
      if (array.name == "i" || array.name == "j") continue;
      std::vector<double> values = *scalars(arrays, array.name);
      const auto [found, fresh] = quantities_.try_emplace(array.name, Quantity{over, {array.name, over}});
      found->second.range.widen(values);
      found->second.whole = found->second.whole && std::ranges::all_of(values, [](double value) {
                              return !std::isfinite(value) || value == std::floor(value);
                            });
      found->second.distribution.add(std::move(values));
    }
  }

  std::map<std::string, Quantity> quantities_;
  std::vector<std::int64_t> ids_;
  std::size_t frames_ = 0, most_necks_ = 0;
  double largest_radius_ = 0.0, mean_radius_ = 0.0;
};

json to_json(const Vec3& vector) { return {vector.x(), vector.y(), vector.z()}; }

json to_json(const std::vector<FieldScale>& fields) {
  json list = json::array();
  for (const FieldScale& field : fields) {
    list.push_back(
        {{"name", field.name}, {"least", field.least}, {"most", field.most}, {"square", field.is_square}});
  }
  return list;
}

// How many frames fit, and whether with necks.
struct Plan {
  std::vector<std::size_t> frames;
  bool with_necks;
};

Plan make_plan(const Survey& survey, std::size_t snapshots, const PageLimits& limits) {
  Plan plan{{}, survey.most_necks() <= limits.most_necks};
  double bytes = bytes_per_particle * static_cast<double>(survey.ids().size());
  if (plan.with_necks) bytes += bytes_per_neck * static_cast<double>(survey.most_necks());
  const auto fitting = static_cast<std::size_t>(limits.bytes / bytes);
  plan.frames = choose_evenly(snapshots, std::clamp<std::size_t>(fitting, 2, limits.most_frames));
  return plan;
}

void note_what_is_left_out(const Plan& plan, const Survey& survey, std::size_t snapshots,
                           std::vector<std::string>& notes) {
  if (plan.frames.size() < snapshots) {
    notes.push_back(fmt::format("3D view: {} of {} snapshots", plan.frames.size(), snapshots));
  }
  if (!plan.with_necks)
    notes.push_back(fmt::format("3D view: without the necks, up to {} a snapshot", survey.most_necks()));
  if (snapshots > most_histograms) {
    notes.push_back(fmt::format("distributions: {} of {} snapshots", most_histograms, snapshots));
  }
}

void pack_frames(const Result& result, const Survey& survey, const Plan& plan, PackingData& data) {
  FramePacker packer(survey.fields(), survey.largest_radius());
  json& frames = data.description["frames"] = json::array();
  for (const std::size_t n : plan.frames) {
    const SnapshotFiles& files = result.snapshots[n];
    const io::Frame frame = read_particles(files.particles);
    if (frame.ids != survey.ids()) {
      throw InputError(files.particles.string() + ": holds other particles than the first snapshot");
    }
    NeckData necks;
    const bool with_necks = plan.with_necks && !files.contacts.empty();
    if (with_necks) necks = necks_of(io::read_vtp(files.contacts), frame.ids);
    const FramePacker::Box box = FramePacker::box_of(frame);
    data.frames.push_back(base64(deflate(packer.pack(frame, with_necks ? &necks : nullptr))));
    frames.push_back({{"time", frame.time},
                      {"origin", to_json(box.origin)},
                      {"size", to_json(box.size)},
                      {"periodic", frame.cell.periodic},
                      {"necks", necks.i.size()}});
  }
}

}  // namespace

std::vector<std::size_t> choose_evenly(std::size_t count, std::size_t wanted) {
  std::vector<std::size_t> chosen;
  if (wanted >= count || count < 2) {
    for (std::size_t n = 0; n < count; ++n) chosen.push_back(n);
    return chosen;
  }
  const std::size_t parts = std::max<std::size_t>(wanted, 2) - 1;
  for (std::size_t n = 0; n <= parts; ++n) chosen.push_back((n * (count - 1) + parts / 2) / parts);
  return chosen;
}

PackingData pack_snapshots(const Result& result, const PageLimits& limits) {
  PackingData data;
  if (result.snapshots.empty()) {
    data.notes.emplace_back("no 3D view and no distributions: the run wrote no snapshots (output.snapshots)");
    return data;
  }
  Survey survey;
  json times = json::array();
  for (const std::size_t n : choose_evenly(result.snapshots.size(), most_histograms)) {
    survey.add(result.snapshots[n]);
    times.push_back(result.snapshots[n].time);
  }
  const Plan plan = make_plan(survey, result.snapshots.size(), limits);
  data.mean_radius = survey.mean_radius_at_start();
  data.distributions = {{"times", times}, {"fields", survey.distributions()}};
  data.description = {
      {"count", survey.ids().size()},
      {"ids", survey.ids().back() == static_cast<std::int64_t>(survey.ids().size()) - 1 ? json()
                                                                                        : json(survey.ids())},
      {"largest_radius", survey.largest_radius()},
      {"mean_radius", data.mean_radius},
      {"fields", to_json(survey.fields())}};
  pack_frames(result, survey, plan, data);
  note_what_is_left_out(plan, survey, result.snapshots.size(), data.notes);
  return data;
}

}  // namespace frit::report
