// The parts of the module; each adds its functions and types.
#pragma once
#include <pybind11/pybind11.h>

namespace mariotte::python {

void add_errors(pybind11::module_& module);
void add_scene(pybind11::module_& module);
void add_figures(pybind11::module_& module);
void add_fit(pybind11::module_& module);
void add_impact(pybind11::module_& module);
void add_laws(pybind11::module_& module);
void add_solve(pybind11::module_& module);
void add_studies(pybind11::module_& module);
void add_sweep(pybind11::module_& module);

}  // namespace mariotte::python
