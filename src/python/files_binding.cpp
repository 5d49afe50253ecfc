#include "python/files_binding.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <utility>
#include <vector>

#include "analyze/snapshots.hpp"
#include "io/frame_files.hpp"
#include "io/packing_csv.hpp"
#include "io/pvd.hpp"
#include "io/series.hpp"
#include "io/vtp.hpp"
#include "python/arrays.hpp"

namespace frit::python {
namespace {

namespace fs = std::filesystem;
using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

py::dict read_series(const fs::path& path) {
  io::Series series = io::read_series(path);
  py::dict dict;
  for (std::size_t column = 0; column < series.columns.size(); ++column)
    dict[py::str(series.columns[column])] = array_of(std::move(series.values[column]));
  return dict;
}

std::vector<double> numbers_of(const std::vector<Vec3>& vectors) {
  std::vector<double> numbers;
  numbers.reserve(3 * vectors.size());
  for (const Vec3& vector : vectors) numbers.insert(numbers.end(), vector.begin(), vector.end());
  return numbers;
}

py::object edges_of(const Cell& cell) {
  if (!cell.periodic) return py::none();
  return array_of(std::vector<double>(cell.size.begin(), cell.size.end()));
}

// Of any known format: ids, positions, radii and every other array by its name, and what is of the whole.
py::tuple read_particles(const fs::path& path) {
  io::Frame frame = io::read_frame(path);
  py::dict arrays;
  arrays["id"] = array_of(std::move(frame.ids));
  arrays["position"] = array_of(numbers_of(frame.positions), 3);
  arrays["radius"] = array_of(std::move(frame.radii));
  add_arrays(arrays, std::move(frame.arrays));
  py::dict whole;
  whole["time"] = frame.time;
  whole["cell_size"] = edges_of(frame.cell);
  add_arrays(whole, std::move(frame.file_arrays));
  return py::make_tuple(arrays, whole);
}

py::dict read_contacts(const fs::path& path) {
  io::PolyData data = io::read_vtp(path);
  py::dict arrays;
  add_arrays(arrays, std::move(data.cell_arrays));
  return arrays;
}

// (time, particles, contacts) of each snapshot.
py::list list_snapshots(const fs::path& folder) {
  const auto files = analyze::list_snapshots(folder);
  std::vector<double> times;
  for (const io::PvdEntry& entry : io::read_pvd(folder / "snapshots.pvd"))
    if (entry.part == 0) times.push_back(entry.time);
  py::list list;
  for (std::size_t n = 0; n < files.size(); ++n)
    list.append(py::make_tuple(times[n], files[n].particles, files[n].contacts));
  return list;
}

void write_packing(const fs::path& path, const Doubles& positions, const Doubles& radii) {
  io::PackingTable table;
  for (py::ssize_t n = 0; n < radii.shape(0); ++n) {
    table.ids.push_back(n);
    table.positions.emplace_back(positions.at(n, 0), positions.at(n, 1), positions.at(n, 2));
    table.radii.push_back(radii.at(n));
  }
  io::write_packing_csv(path, table);
}

}  // namespace

void add_files(py::module_& module) {
  module.def("read_series", &read_series, py::arg("path"));
  module.def("read_particles", &read_particles, py::arg("path"));
  module.def("read_contacts", &read_contacts, py::arg("path"));
  module.def("list_snapshots", &list_snapshots, py::arg("folder"));
  module.def("write_packing", &write_packing, py::arg("path"), py::arg("positions"), py::arg("radii"));
}

}  // namespace frit::python
