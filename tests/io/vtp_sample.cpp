// Writes the files that read_vtp.py reads with VTK into the folder given.
#include <cstdint>
#include <filesystem>
#include <vector>

#include "io/vtp.hpp"

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return 2;
  const std::filesystem::path folder = arguments[1];
  constexpr int count = 20000;  // several compressed blocks an array
  frit::io::Frame frame;
  frame.time = 1.0 / 3.0;
  frame.cell = {.periodic = true, .size = {1, 2, 3}};
  std::vector<double> velocity;
  std::vector<std::int64_t> coordination;
  for (int row = 0; row < count; ++row) {
    frame.ids.push_back(10 * row);
    frame.positions.emplace_back(row / 7.0, -row, 1e-6 * row);
    frame.radii.push_back(1.0 / (row + 3.0));
    velocity.insert(velocity.end(), {row / 3.0, 0.0, -1.0 * row});
    coordination.push_back(row % 13);
  }
  frame.arrays = {{"velocity", 3, velocity}, {"coordination", 1, coordination}};
  frit::io::write_vtp(folder / "particles.vtp", frame);

  frit::io::ContactFrame network;
  network.time = frame.time;
  network.segments = {{{0, 0, 0}, {1, 0, 0}}, {{1, 0, 0}, {2, 5, -1}}};
  network.arrays = {{"neck_radius", 1, std::vector<double>{0.1, 0.7}}};
  frit::io::write_vtp(folder / "contacts.vtp", network);
  frit::io::write_vtp(folder / "none.vtp", frit::io::ContactFrame{});
}
