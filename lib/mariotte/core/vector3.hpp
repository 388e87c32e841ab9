// Vectors of space: e1 is normal to a plane, e2 and e3 lie in it.
#pragma once
#include <cmath>

namespace mariotte {

/// A vector of space by its components along e1, e2, e3.
struct Vector3 {
  double e1 = 0, e2 = 0, e3 = 0;
  bool operator==(const Vector3&) const = default;
};

/// a + b.
inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.e1 + b.e1, a.e2 + b.e2, a.e3 + b.e3};
}
/// a − b.
inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.e1 - b.e1, a.e2 - b.e2, a.e3 - b.e3};
}
/// s a.
inline Vector3 operator*(double s, const Vector3& a) {
  return {s * a.e1, s * a.e2, s * a.e3};
}
/// a · b.
inline double dot(const Vector3& a, const Vector3& b) {
  return a.e1 * b.e1 + a.e2 * b.e2 + a.e3 * b.e3;
}
/// a × b.
inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.e2 * b.e3 - a.e3 * b.e2, a.e3 * b.e1 - a.e1 * b.e3, a.e1 * b.e2 - a.e2 * b.e1};
}
/// Length, without overflow.
inline double norm(const Vector3& a) {
  return std::hypot(a.e1, a.e2, a.e3);
}
/// The part of a vector that lies in the plane.
inline Vector3 tangential(const Vector3& a) {
  return {0, a.e2, a.e3};
}

inline constexpr Vector3 normal_axis{1, 0, 0};

}  // namespace mariotte
