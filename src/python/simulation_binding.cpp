#include "python/simulation_binding.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "config/case_reader.hpp"
#include "config/case_writer.hpp"
#include "python/arrays.hpp"
#include "python/session.hpp"
#include "run/folders.hpp"
#include "run/machine.hpp"

namespace frit::python {
namespace {

using NoGil = py::call_guard<py::gil_scoped_release>;

// Columns of series.csv so far, one number a row.
py::dict series_of(const Session& session) {
  std::vector<observe::Row> rows;
  {
    const py::gil_scoped_release released;
    rows = session.rows();
  }
  py::dict series;
  for (std::size_t column = 0; column < rows.front().size(); ++column) {
    std::vector<double> values;
    values.reserve(rows.size());
    for (const observe::Row& row : rows) values.push_back(row[column].value);
    series[py::str(rows.front()[column].name)] = array_of(std::move(values));
  }
  return series;
}

py::object ending_of(const Session& session) {
  std::optional<run::Ending> ending;
  {
    const py::gil_scoped_release released;
    ending = session.ending();
  }
  if (!ending) return py::none();
  return py::make_tuple(ending->code, ending->reason);
}

py::dict counts_of(const Session& session) {
  run::Totals totals;
  {
    const py::gil_scoped_release released;
    totals = session.totals();
  }
  py::dict counts;
  counts["steps"] = totals.steps;
  counts["rejected_steps"] = totals.rejected_steps;
  counts["newton_iterations"] = totals.newton_iterations;
  counts["solver_iterations"] = totals.solver_iterations;
  counts["accuracy"] = totals.accuracy();
  return counts;
}

}  // namespace

void add_case(py::module_& module) {
  py::class_<config::Case>(module, "Case")
      .def(py::init([](const std::string& text, const std::string& name,
                       const std::vector<std::string>& overrides) {
             return config::parse_case(text, name, overrides);
           }),
           py::arg("text"), py::arg("name"), py::arg("overrides"))
      .def("to_toml", [](const config::Case& whole) { return config::write_case(whole, run::version()); });
  module.def(
      "load_case",
      [](const std::filesystem::path& path, const std::vector<std::string>& overrides) {
        return config::load_case(path, overrides);
      },
      py::arg("path"), py::arg("overrides"));
  module.def(
      "check_result_folder",
      [](const std::filesystem::path& folder, bool replace) {
        run::check_result_folder(folder, replace ? run::Existing::replace : run::Existing::refuse);
      },
      py::arg("folder"), py::arg("replace"));
}

void add_session(py::module_& module) {
  py::class_<Session, std::shared_ptr<Session>>(module, "Session")
      .def(py::init<const config::Case&, std::optional<std::filesystem::path>>(), py::arg("case"),
           py::arg("folder"), NoGil())
      .def("step", &Session::step, NoGil())
      .def(
          "stop",
          [](Session& session, int code, const std::string& reason) {
            session.stop({code, reason});
          },
          py::arg("code"), py::arg("reason"), NoGil())
      .def(
          "state", [](const Session& session) { return std::const_pointer_cast<Moment>(session.moment()); },
          NoGil())
      .def("row_count", &Session::row_count, NoGil())
      .def("series", &series_of)
      .def("ending", &ending_of)
      .def("counts", &counts_of)
      .def("warnings", [](const Session& session) { return session.setup().warnings; })
      .def("time_scale", [](const Session& session) { return session.setup().time_scale; });
}

}  // namespace frit::python
