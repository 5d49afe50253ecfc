#include "observe/row.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "observe/density.hpp"
#include "observe/motion.hpp"
#include "observe/non_affine.hpp"
#include "observe/rearrangement.hpp"
#include "observe/rotation.hpp"

namespace frit::observe {
namespace {

const Unit radian{" [rad]"};

void add_rearrangement(Row& row, const Rearrangement& moved) {
  add_distribution(row, "rearrangement_deviation", distribution_of(moved.deviation));
  row.push_back({"rearrangement_pair_ratio", moved.pair_ratio});
  add_distribution(row, "rearrangement_d2min", distribution_of(moved.d2min));
  add_distribution(row, "contacts_gained", distribution_of(moved.contacts_gained));
  add_distribution(row, "contacts_lost", distribution_of(moved.contacts_lost));
  row.push_back({"neck_angle_change [rad]", moved.neck_angle_change_rms});
  add_distribution(row, "neck_angle_change", distribution_of(moved.neck_angle_change), radian);
}

void add_turning(Row& row, const Reference& reference, const State& state) {
  add_distribution(row, "rotation", distribution_of(own_rotations(reference, state)), radian);
  add_distribution(row, "rolling", distribution_of(state.contacts.rolling_path), radian);
  add_distribution(row, "sliding", distribution_of(relative_sliding(state)));
  add_distribution(row, "twisting", distribution_of(state.contacts.twisting_path), radian);
}

}  // namespace

void add_distribution(Row& row, const std::string& name, const Distribution& values, Unit unit) {
  const std::string suffix(unit.text);
  row.push_back({name + "_mean" + suffix, values.mean});
  row.push_back({name + "_q10" + suffix, values.q10});
  row.push_back({name + "_q50" + suffix, values.q50});
  row.push_back({name + "_q90" + suffix, values.q90});
}

Row observe_row(const Reference& reference, const State& state, const NeckLaw& law) {
  const NeckStatistics necks = neck_statistics(state, law);
  const Vec3 strain = motion_since(reference, state).linear_strain;
  Row row{{"time [s]", state.time},
          {"temperature [K]", state.temperature},
          {"relative_density", relative_density(reference, state)},
          {"union_density", union_density(reference, state)},
          {"coordination", necks.coordination},
          {"rattlers", necks.rattlers},
          {"contacts", static_cast<double>(necks.contacts)}};
  add_distribution(row, "neck_ratio", necks.neck_ratio);
  row.push_back({"linear_strain_x", strain.x()});
  row.push_back({"linear_strain_y", strain.y()});
  row.push_back({"linear_strain_z", strain.z()});
  row.push_back({"theta [m^5 s/(N s)]", state.theta});
  add_rearrangement(row, rearrangement_since(reference, state));
  add_turning(row, reference, state);
  row.push_back({"contacts_thinning", necks.thinning});
  row.push_back({"sliding_dissipation_share", sliding_dissipation_share(state.contacts, law)});
  row.push_back({"non_affine_share", non_affine_share(state)});
  return row;
}

double value_of(const Row& row, std::string_view name) {
  const auto found =
      std::find_if(row.begin(), row.end(), [&](const Column& column) { return column.name == name; });
  if (found == row.end()) throw ContractError("no column \"" + std::string(name) + "\" in the row");
  return found->value;
}

}  // namespace frit::observe
