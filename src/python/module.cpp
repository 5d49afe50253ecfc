// The compiled part of `import frit`; the package around it is in frit/.
#include <pybind11/pybind11.h>

#include <string>

#include "config/materials.hpp"
#include "config/reference.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "python/errors.hpp"
#include "python/files_binding.hpp"
#include "python/simulation_binding.hpp"
#include "python/state_binding.hpp"
#include "run/machine.hpp"

namespace py = pybind11;

namespace {

void set_threads(int threads) {
  if (threads < 0 || threads > 4096)
    throw frit::InputError("threads: " + std::to_string(threads) +
                           "; allowed: 1 to 4096, or 0 for every processor");
  frit::set_threads(threads);
}

}  // namespace

PYBIND11_MODULE(_frit, module) {
  module.attr("__version__") = std::string(frit::run::version());
  frit::python::add_errors(module);
  frit::python::add_state(module);
  frit::python::add_case(module);
  frit::python::add_session(module);
  frit::python::add_files(module);
  module.def(
      "describe", [](const std::string& key) { return frit::config::describe(key); }, py::arg("key") = "");
  module.def("materials", [] { return frit::config::materials_text(); });
  module.def("set_threads", &set_threads, py::arg("threads"));
  module.def("threads", &frit::threads);
}
