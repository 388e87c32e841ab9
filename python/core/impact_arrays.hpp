// Arrays of NumPy over the numbers of a result.
#pragma once
#include <pybind11/pybind11.h>

#include "impact.hpp"

namespace mariotte::python {

void add_arrays(pybind11::class_<Impact>& type);

}  // namespace mariotte::python
