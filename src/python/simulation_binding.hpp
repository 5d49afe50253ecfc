// The case and the run that Python drives: _frit.Case and _frit.Session.
#pragma once

#include <pybind11/pybind11.h>

namespace frit::python {

void add_case(pybind11::module_& module);
void add_session(pybind11::module_& module);

}  // namespace frit::python
