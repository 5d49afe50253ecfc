// Files of packings and results as arrays.
#pragma once

#include <pybind11/pybind11.h>

namespace frit::python {

void add_files(pybind11::module_& module);

}  // namespace frit::python
