#include "observe/network_row.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "observe/contact_graph.hpp"
#include "observe/force_chains.hpp"
#include "observe/particle_stress.hpp"

namespace frit::observe {
namespace {

// Largest cluster's share of the particles.
double largest_share(const ContactGraph& graph) {
  std::vector<double> sizes;
  for (const std::int32_t cluster : clusters_of(graph)) {
    sizes.resize(std::max(sizes.size(), static_cast<std::size_t>(cluster) + 1));
    sizes[cluster] += 1.0;
  }
  if (sizes.empty()) return no_value;
  return *std::max_element(sizes.begin(), sizes.end()) / static_cast<double>(graph.size());
}

double mean_magnitude(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += std::abs(value);
  return values.empty() ? no_value : sum / static_cast<double>(values.size());
}

double pulled_share(const std::vector<double>& forces) {
  double pulled = 0.0;
  for (const double force : forces) pulled += force < 0.0 ? 1.0 : 0.0;
  return pulled / static_cast<double>(forces.size());
}

void add_graph(Row& row, const State& state) {
  const ContactGraph graph(state);
  row.push_back({"clustering", distribution_of(clustering_coefficients(graph)).mean});
  row.push_back({"transitivity", transitivity(graph)});
  row.push_back({"path_length", characteristic_path_length(graph)});
  row.push_back({"largest_cluster", largest_share(graph)});
}

void add_stress(Row& row, const Mat3& stress) {
  row.push_back({"mean_stress_xx [Pa]", stress(0, 0)});
  row.push_back({"mean_stress_yy [Pa]", stress(1, 1)});
  row.push_back({"mean_stress_zz [Pa]", stress(2, 2)});
  row.push_back({"mean_stress_yz [Pa]", stress(1, 2)});
  row.push_back({"mean_stress_xz [Pa]", stress(0, 2)});
  row.push_back({"mean_stress_xy [Pa]", stress(0, 1)});
}

void add_chains(Row& row, const std::string& kind, const ForceChains& chains) {
  row.push_back({kind + "_chains", static_cast<double>(chains.sizes.size())});
  row.push_back({kind + "_chain_size", distribution_of(chains.sizes).mean});
  row.push_back({kind + "_chain_share", chains.particle_share});
}

}  // namespace

std::vector<double> relative_forces(const Contacts& contacts) {
  const double mean = mean_magnitude(contacts.normal_force);
  if (!(mean > 0.0)) return {};
  std::vector<double> forces = contacts.normal_force;
  for (double& force : forces) force /= mean;
  return forces;
}

Row observe_network(const State& state, const NeckLaw& law, double density) {
  const std::vector<double> forces = relative_forces(state.contacts);
  const bool has_forces = !forces.empty();
  Row row{{"time [s]", state.time}, {"relative_density", density}};
  add_distribution(row, "degree", distribution_of(coordination_numbers(state)));
  add_graph(row, state);
  row.push_back({"normal_force_magnitude_mean [N]", mean_magnitude(state.contacts.normal_force)});
  row.push_back({"contacts_pulled", has_forces ? pulled_share(forces) : no_value});
  add_distribution(row, "normal_force_ratio", distribution_of(forces));
  const auto stresses = has_forces ? particle_stresses(state, law) : std::vector<Mat3>{};
  add_stress(row, has_forces ? mean_stress(state, stresses, density) : Mat3::Constant(no_value));
  for (const Load load : {Load::compression, Load::tension}) {
    const std::string kind = load == Load::compression ? "compression" : "tension";
    if (has_forces) {
      add_chains(row, kind, find_force_chains(state, stresses, load));
    } else {
      for (const char* column : {"_chains", "_chain_size", "_chain_share"})
        row.push_back({kind + column, no_value});
    }
  }
  return row;
}

}  // namespace frit::observe
