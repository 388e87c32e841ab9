// Vectors of space: e1 is normal to a plane, e2 and e3 lie in it.
#pragma once
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace mariotte {

/// A vector of space by its components along e1, e2, e3: numbers, or values with slopes.
template <class T>
struct BasicVector3 {
  T e1 = 0, e2 = 0, e3 = 0;
  bool operator==(const BasicVector3&) const = default;
};
/// Of plain numbers.
using Vector3 = BasicVector3<double>;

/// a + b.
template <class T>
BasicVector3<T> operator+(const BasicVector3<T>& a, const BasicVector3<T>& b) {
  return {a.e1 + b.e1, a.e2 + b.e2, a.e3 + b.e3};
}
/// a − b.
template <class T>
BasicVector3<T> operator-(const BasicVector3<T>& a, const BasicVector3<T>& b) {
  return {a.e1 - b.e1, a.e2 - b.e2, a.e3 - b.e3};
}
/// s a.
template <class T>
BasicVector3<T> operator*(const std::type_identity_t<T>& s, const BasicVector3<T>& a) {
  return {s * a.e1, s * a.e2, s * a.e3};
}
/// a · b.
template <class T>
T dot(const BasicVector3<T>& a, const BasicVector3<T>& b) {
  return a.e1 * b.e1 + a.e2 * b.e2 + a.e3 * b.e3;
}
/// a × b.
template <class T>
BasicVector3<T> cross(const BasicVector3<T>& a, const BasicVector3<T>& b) {
  return {a.e2 * b.e3 - a.e3 * b.e2, a.e3 * b.e1 - a.e1 * b.e3, a.e1 * b.e2 - a.e2 * b.e1};
}
/// Length, without overflow.
inline double norm(const Vector3& a) {
  return std::hypot(a.e1, a.e2, a.e3);
}
/// Component along e1, e2, e3 for 0, 1, 2.
template <class T>
T component(const BasicVector3<T>& a, std::size_t axis) {
  return axis == 0 ? a.e1 : axis == 1 ? a.e2 : a.e3;
}
/// The part of a vector that lies in the plane.
template <class T>
BasicVector3<T> tangential(const BasicVector3<T>& a) {
  return {0, a.e2, a.e3};
}

inline constexpr Vector3 normal_axis{1, 0, 0};

}  // namespace mariotte
