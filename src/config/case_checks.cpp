#include "config/case_checks.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "config/case_reader.hpp"
#include "config/schema.hpp"
#include "config/values.hpp"

namespace frit::config {
namespace {

class Checks {
 public:
  Checks(const Case& whole, const Given& given, Faults& faults)
      : whole_(whole), given_(given), faults_(faults) {}

  void run() {
    check_packing();
    check_schema_conditions();
    check_cell();
    check_material();
    check_necks();
    check_temperature();
    check_steps();
    check_stop();
    check_groups();
  }

 private:
  bool has(const std::string& key) const { return given_.contains(key); }
  bool sound(const std::string& key) const { return !faults_.has(key); }
  void fault(const std::string& key, const std::string& what) {
    const auto place = given_.find(key);
    faults_.add(place == given_.end() ? Place{} : place->second, key, what);
  }

  void check_packing() {
    if (has("packing.file") && has("packing.generate"))
      fault("packing.generate", "there is packing.file too; allowed is one of them");
    if (!has("packing.file") && !has("packing.generate"))
      fault("packing",
            "missing; allowed is either packing.file or packing.generate, e.g. generate = \"random-dense\"");
  }

  // Which packing there is, where that is not itself in doubt.
  bool packing_known() const {
    return has("packing.file") != has("packing.generate") && sound("packing.file") &&
           sound("packing.generate");
  }

  bool fulfilled(Applies applies) const {
    const bool file = !packing_known() || has("packing.file");
    const bool generated = !packing_known() || has("packing.generate");
    const bool periodic = !sound("cell.kind") || whole_.cell.kind == CellKind::periodic;
    switch (applies) {
      case Applies::always:
        return true;
      case Applies::file_packing:
        return file;
      case Applies::generated_packing:
        return generated;
      case Applies::random_dense:
        return !packing_known() || whole_.packing.generate == Generator::random_dense;
      case Applies::periodic:
        return periodic;
      case Applies::periodic_file:
        return periodic && file;
      case Applies::implicit:
        return !sound("method.name") || whole_.method.name != MethodName::verlet;
      case Applies::verlet:
        return !sound("method.name") || whole_.method.name == MethodName::verlet;
    }
    return true;
  }

  // Keys that mean nothing here, or that cannot be had yet, must stay at their defaults.
  void check_schema_conditions() {
    Case actual = whole_, defaults = default_case();
    Target here{.whole = actual}, there{.whole = defaults};
    for (const Key& key : schema()) {
      const std::string path(key.path);
      if (!has(path) || !sound(path)) continue;
      const bool unused = !fulfilled(key.applies), missing = key.status == Status::not_available_yet;
      if ((!unused && !missing) || write_value(key, here) == write_value(key, there)) continue;
      const std::string allowed =
          key.fallback.empty() ? "leave it out" : fmt::format("allowed: {}", key.fallback);
      fault(path, (missing ? "not available yet" : "means nothing here, " + applies_text(key.applies)) +
                      "; " + allowed);
    }
  }

  void check_cell() {
    if (has("cell.stress") && has("cell.strain_rate"))
      fault("cell.strain_rate", "there is cell.stress too; allowed is one of them");
    const bool periodic = sound("cell.kind") && whole_.cell.kind == CellKind::periodic;
    if (periodic && packing_known() && has("packing.file") && !has("cell.size"))
      fault("cell.size",
            "missing; a periodic packing from a file needs it, e.g. [\"1 mm\", \"1 mm\", \"1 mm\"]");
  }

  void check_material() {
    if (has("material.use")) return;
    for (const Key& key : schema()) {
      const std::string path(key.path);
      const bool is_needed = path != "material.use" && path != "material.melting_temperature";
      if (path.starts_with("material.") && is_needed && !has(path))
        fault(path,
              "missing; allowed is " + type_text(key) + "; or start from a material, e.g. use = \"copper\"");
    }
  }

  // A neck cannot be born beyond its equilibrium.
  void check_necks() {
    const double psi = whole_.material.dihedral_angle;
    if (!sound("material.use") || !sound("material.dihedral_angle") || psi <= 0.0) return;
    const double largest = std::sin(psi / 2.0);
    const std::map<std::string, double> ratios{
        {"contact.birth_neck_ratio", whole_.contact.birth_neck_ratio},
        {"contact.initial_neck_ratio", whole_.contact.initial_neck_ratio}};
    for (const auto& [key, ratio] : ratios)
      if (sound(key) && ratio >= largest)
        fault(key, fmt::format("{} is beyond equilibrium; allowed: below sin(dihedral_angle/2) = {:.6g}",
                               ratio, largest));
  }

  void check_temperature() {
    double before = whole_.temperature.start;
    for (std::size_t n = 0; n < whole_.temperature.program.size(); ++n) {
      const TemperatureStep& step = whole_.temperature.program[n];
      const std::string shown = fmt::format("temperature.program[{}]", n);
      const bool ramp = has(shown + ".rate") || has(shown + ".to"), hold = has(shown + ".hold");
      const bool whole_ramp = has(shown + ".rate") && has(shown + ".to");
      if (sound(shown) && (ramp == hold || (ramp && !whole_ramp)))
        fault(shown,
              "allowed is either a ramp { rate = \"10 K/min\", to = \"1050 degC\" } or a hold { hold = \"1 "
              "h\" }");
      if (step.rate && *step.rate == 0.0)
        fault(shown + ".rate", "a ramp of rate 0 never arrives; allowed: not 0 K/s");
      if (step.rate && step.to && *step.rate < 0.0 && *step.to > before)
        fault(shown + ".rate",
              fmt::format("a negative rate does not heat from {:.6g} K to {:.6g} K; allowed: above "
                          "0 K/s",
                          before, *step.to));
      before = step.to.value_or(before);
    }
  }

  void check_steps() {
    const auto& [smallest, largest] = std::pair(whole_.method.smallest_step, whole_.method.largest_step);
    if (smallest && largest && *smallest > *largest)
      fault("method.smallest_step",
            fmt::format("{:.6g} s is above method.largest_step; allowed: at most {:.6g} s", *smallest,
                        *largest));
    if (!whole_.method.time_step) return;
    for (const std::string key : {"method.smallest_step", "method.largest_step"})
      if (has(key) && (key == "method.smallest_step" ? smallest : largest))
        fault(key, "means nothing beside a fixed method.time_step; allowed: \"auto\"");
  }

  void check_stop() {
    if (!has("stop.time") && !has("stop.relative_density"))
      fault("stop",
            "missing; at least one is needed: stop.time, e.g. \"2 h\", or stop.relative_density, e.g. 0.9");
  }

  void check_groups() {
    std::map<std::int64_t, std::size_t> group_of;
    for (std::size_t n = 0; n < whole_.particles.size(); ++n) {
      const std::string shown = fmt::format("particles[{}]", n);
      if (sound(shown) && !has(shown + ".ids"))
        fault(shown + ".ids", "missing; allowed is a list of rows, e.g. [0, 1]");
      for (const auto id : whole_.particles[n].ids) {
        const auto [known, added] = group_of.emplace(id, n);
        if (!added)
          fault(shown + ".ids", fmt::format("particle {} is named before, in particles[{}]; allowed: once",
                                            id, known->second));
      }
    }
  }

  const Case& whole_;
  const Given& given_;
  Faults& faults_;
};

}  // namespace

void check_case(const Case& whole, const Given& given, Faults& faults) { Checks(whole, given, faults).run(); }

void resolve_case(Case& whole, const Given& given) {
  const bool stress_holds = whole.cell.kind == CellKind::periodic && !whole.cell.strain_rate;
  if (!stress_holds) whole.cell.stress.reset();
  const bool other_interval = given.contains("output.every_time") || given.contains("output.every_steps");
  if (other_interval && !given.contains("output.every_density")) whole.output.every_density.reset();
  double before = whole.temperature.start;
  for (TemperatureStep& step : whole.temperature.program) {
    if (!step.to) continue;
    if (step.rate) step.rate = std::copysign(*step.rate, *step.to < before ? -1.0 : 1.0);
    before = *step.to;
  }
}

}  // namespace frit::config
