#include "observe/force_chains.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "observe/contact_graph.hpp"
#include "observe/statistics.hpp"

namespace frit::observe {
namespace {

// The principal stress that counts and its direction; of tension or compression its magnitude, at least 0.
struct Principal {
  double magnitude = 0.0;  // [Pa]
  Vec3 direction = Vec3::Zero();
};

std::vector<Principal> principals_of(const std::vector<Mat3>& stresses, Load load) {
  const double sign = load == Load::compression ? -1.0 : 1.0;
  std::vector<Principal> principals(stresses.size());
  for (std::size_t row = 0; row < stresses.size(); ++row) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(sign * stresses[row]);  // ascending
    principals[row] = {std::max(0.0, solver.eigenvalues()[2]), solver.eigenvectors().col(2)};
  }
  return principals;
}

double mean_magnitude(const std::vector<Principal>& principals) {
  double sum = 0.0;
  for (const Principal& principal : principals) sum += principal.magnitude;
  return sum / static_cast<double>(principals.size());
}

}  // namespace

ForceChains find_force_chains(const State& state, const std::vector<Mat3>& stresses, Load load) {
  if (stresses.empty()) return {{}, no_value};
  const std::vector<Principal> principals = principals_of(stresses, load);
  const double mean = mean_magnitude(principals);
  const auto passes_on = [&](std::int32_t row, const Vec3& along) {
    const Principal& own = principals[row];
    return own.magnitude > mean && std::abs(own.direction.dot(along)) >= std::cos(chain_angle);
  };
  const Contacts& contacts = state.contacts;
  std::vector<std::int32_t> linked_i, linked_j;  // the contacts that pass the load on
  std::vector<Image> images;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::int32_t i = contacts.i[k], j = contacts.j[k];
    const Vec3 along =
        state.cell.separation(state.particles.position[i], state.particles.position[j], contacts.image[k])
            .normalized();
    if (!passes_on(i, along) || !passes_on(j, along)) continue;
    linked_i.push_back(i);
    linked_j.push_back(j);
    images.push_back(contacts.image[k]);
  }
  std::vector<double> sizes;
  for (const std::int32_t cluster : clusters_of({stresses.size(), {linked_i, linked_j, images}})) {
    sizes.resize(std::max(sizes.size(), static_cast<std::size_t>(cluster) + 1));
    sizes[cluster] += 1.0;
  }
  std::erase_if(sizes, [](double size) { return size < static_cast<double>(shortest_chain); });
  double members = 0.0;
  for (const double size : sizes) members += size;
  return {sizes, members / static_cast<double>(stresses.size())};
}

}  // namespace frit::observe
