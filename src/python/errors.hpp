// The program's errors as Python exceptions, with the same messages.
#pragma once

#include <pybind11/pybind11.h>

namespace frit::python {

// frit.Error and below it InputError (with .faults), MachineError and ContractError.
void add_errors(pybind11::module_& module);

}  // namespace frit::python
