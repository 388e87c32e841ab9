// Arrays of NumPy over memory of C++, and back.
#pragma once
#include <pybind11/numpy.h>

#include <optional>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/core/vector3.hpp"

namespace mariotte::python {

namespace py = pybind11;

using Extents = std::vector<py::ssize_t>;
/// What is read from: converted to contiguous doubles where it is not that already.
using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// A read-only array over memory that lives as long as `owner`; `strides` in bytes.
template <class Number>
py::array view(const Number* data, Extents shape, Extents strides, const py::handle& owner) {
  py::array array(py::dtype::of<Number>(), std::move(shape), std::move(strides), data, owner);
  py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
  return array;
}

/// The same of contiguous memory.
template <class Number>
py::array view(const std::vector<Number>& numbers, const py::handle& owner) {
  return view(numbers.data(), {std::ssize(numbers)}, {sizeof(Number)}, owner);
}

/// The same of one member of each element.
template <class Element>
py::array view(const std::vector<Element>& elements, double Element::*member, const py::handle& owner) {
  const double* const first = elements.empty() ? nullptr : &(elements.front().*member);
  return view(first, {std::ssize(elements)}, {sizeof(Element)}, owner);
}

/// One row per element: as many components of a vector of it as the dimension has.
template <class Element>
py::array view(const std::vector<Element>& elements, Vector3 Element::*member, int dimension,
               const py::handle& owner) {
  const double* const first = elements.empty() ? nullptr : &(elements.front().*member).e1;
  return view(first, {std::ssize(elements), dimension}, {sizeof(Element), sizeof(double)}, owner);
}

/// The same of a spin, which in the plane is one number.
template <class Element>
py::array view_of_spins(const std::vector<Element>& elements, Vector3 Element::*member, int dimension,
                        const py::handle& owner) {
  if (dimension == 3) return view(elements, member, dimension, owner);
  const double* const first = elements.empty() ? nullptr : &(elements.front().*member).e3;
  return view(first, {std::ssize(elements)}, {sizeof(Element)}, owner);
}

/// A new array that owns its numbers.
template <class Number>
py::array owned(std::vector<Number> numbers, Extents shape) {
  auto* const kept = new std::vector<Number>(std::move(numbers));
  const py::capsule owner(kept, [](void* memory) { delete static_cast<std::vector<Number>*>(memory); });
  return py::array(py::dtype::of<Number>(), std::move(shape), kept->data(), owner);
}

/// Nan where there is none.
inline double or_nan(const std::optional<double>& number) {
  return number.value_or(std::numeric_limits<double>::quiet_NaN());
}
inline std::vector<double> or_nan(const std::vector<std::optional<double>>& numbers) {
  std::vector<double> all;
  for (const auto& number : numbers) all.push_back(or_nan(number));
  return all;
}

}  // namespace mariotte::python
