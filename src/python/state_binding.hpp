// frit.State: the particles and contacts of one moment as read-only NumPy arrays.
#pragma once

#include <pybind11/pybind11.h>

namespace frit::python {

void add_state(pybind11::module_& module);

}  // namespace frit::python
