#include "python/errors.hpp"

#include <pybind11/stl.h>

#include <exception>
#include <string>

#include "core/error.hpp"

namespace frit::python {
namespace py = pybind11;
namespace {

// Exception types live as long as the interpreter; a static py::object would be destroyed after it.
struct Types {
  PyObject *input = nullptr, *machine = nullptr, *contract = nullptr;
};
Types types;

PyObject* add_type(py::module_& module, const char* name, const char* text, const py::tuple& bases) {
  const std::string full_name = std::string("frit.") + name;
  PyObject* type = PyErr_NewExceptionWithDoc(full_name.c_str(), text, bases.ptr(), nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.add_object(name, type);
  return type;
}

void raise_input_error(const InputError& error) {
  const py::object exception = py::reinterpret_borrow<py::object>(types.input)(error.what());
  exception.attr("faults") = error.faults();
  PyErr_SetObject(types.input, exception.ptr());
}

void translate(std::exception_ptr thrown) {
  try {
    std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    raise_input_error(error);
  } catch (const MachineError& error) {
    PyErr_SetString(types.machine, error.what());
  } catch (const ContractError& error) {
    PyErr_SetString(types.contract, error.what());
  }
}

}  // namespace

void add_errors(py::module_& module) {
  PyObject* base =
      add_type(module, "Error", "What all errors of frit are.", py::make_tuple(py::handle(PyExc_Exception)));
  const auto below_base = [&](PyObject* python) {
    return py::make_tuple(py::handle(base), py::handle(python));
  };
  types.input = add_type(module, "InputError",
                         "The input is wrong. faults: list of all faults found together, each naming its "
                         "file, line or key.",
                         below_base(PyExc_ValueError));
  types.machine =
      add_type(module, "MachineError", "The machine failed: disk, memory, a file that cannot be written.",
               below_base(PyExc_RuntimeError));
  types.contract = add_type(module, "ContractError", "A check of frit itself failed: please report it.",
                            below_base(PyExc_RuntimeError));
  py::register_exception_translator(&translate);
}

}  // namespace frit::python
