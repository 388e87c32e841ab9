#include "bindings.hpp"
#include "mariotte/version.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The compiled part of mariotte; use the package.";
  module.attr("version") = mariotte::version;
  mariotte::python::add_errors(module);
  mariotte::python::add_scene(module);
  mariotte::python::add_impact(module);
  mariotte::python::add_figures(module);
  mariotte::python::add_fit(module);
  mariotte::python::add_laws(module);
  mariotte::python::add_solve(module);
  mariotte::python::add_studies(module);
  mariotte::python::add_sweep(module);
}
