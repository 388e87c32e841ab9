// Attitude of a rigid body as a unit quaternion: rotate(q, v) turns body components into space components.
#pragma once
#include <cmath>
#include <numbers>

#include "mariotte/core/vector3.hpp"

namespace mariotte {

/// w + x i + y j + z k; a rotation if its size is 1. Of numbers, or of values with slopes.
template <class T>
struct BasicQuaternion {
  T w = 1, x = 0, y = 0, z = 0;
};
/// Of plain numbers.
using Quaternion = BasicQuaternion<double>;

/// The rotation q, then p.
template <class T>
BasicQuaternion<T> operator*(const BasicQuaternion<T>& p, const BasicQuaternion<T>& q) {
  return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
          p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}
/// Every component times s.
template <class T>
BasicQuaternion<T> operator*(const std::type_identity_t<T>& s, const BasicQuaternion<T>& q) {
  return {s * q.w, s * q.x, s * q.y, s * q.z};
}
/// The inverse rotation.
template <class T>
BasicQuaternion<T> conjugate(const BasicQuaternion<T>& q) {
  return {q.w, -q.x, -q.y, -q.z};
}
/// The same direction at size 1.
inline Quaternion normalized(const Quaternion& q) {
  const double size = std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z);
  return {q.w / size, q.x / size, q.y / size, q.z / size};
}

/// v + 2 i × (i × v + w v) with the imaginary part i. Inline: a call would wait for numbers just stored.
template <class T>
inline BasicVector3<T> rotate(const BasicQuaternion<T>& q, const std::type_identity_t<BasicVector3<T>>& v) {
  const BasicVector3<T> imaginary{q.x, q.y, q.z};
  return v + 2.0 * cross(imaginary, cross(imaginary, v) + q.w * v);
}

/// Rotation by `angle` [rad] about a unit vector.
inline Quaternion rotation(const Vector3& axis, double angle) {
  const double half = std::sin(angle / 2);
  return {std::cos(angle / 2), half * axis.e1, half * axis.e2, half * axis.e3};
}

/// Rates of a quaternion that turns with angular velocity ω (space axes): q̇ = ½ ω q.
template <class T>
BasicQuaternion<T> quaternion_rate(const BasicQuaternion<T>& q, const BasicVector3<T>& spin) {
  return 0.5 * (BasicQuaternion<T>{0, spin.e1, spin.e2, spin.e3} * q);
}

/// R₁(α) R₂(β) R₃(γ), the rotation by γ about axis 3 first [rad].
struct EulerAngles {
  double alpha = 0, beta = 0, gamma = 0;
};

/// The attitude that the angles describe.
inline Quaternion from_euler(const EulerAngles& angles) {
  return rotation({1, 0, 0}, angles.alpha) * rotation({0, 1, 0}, angles.beta) *
         rotation({0, 0, 1}, angles.gamma);
}

/// The other angles of the same rotation: α and γ half a turn away.
inline EulerAngles other_angles(const EulerAngles& angles) {
  const auto half_turn = [](double angle) { return std::copysign(std::numbers::pi, angle); };
  return {angles.alpha - half_turn(angles.alpha), half_turn(angles.beta) - angles.beta,
          angles.gamma - half_turn(angles.gamma)};
}

/// The angles of a rotation. Of the two triples it is that with β within ±90°, unless both α and γ were
/// beyond that: so a body that turns in a plane keeps α = γ = 0. Where β = ±90° makes them ambiguous, γ = 0.
inline EulerAngles to_euler(const Quaternion& q) {
  const Vector3 one = rotate(q, {1, 0, 0}), two = rotate(q, {0, 1, 0}), three = rotate(q, {0, 0, 1});
  const double level = std::hypot(one.e1, two.e1);
  const double beta = std::atan2(three.e1, level);
  if (level == 0) return {std::atan2(two.e3, two.e2), beta, 0};
  // a zero less another is +0, where −0 would be an angle of −180° or be shown as such
  const EulerAngles angles{std::atan2(0 - three.e2, three.e3), beta, std::atan2(0 - two.e1, one.e1)};
  constexpr double right = std::numbers::pi / 2;
  return std::abs(angles.alpha) > right && std::abs(angles.gamma) > right ? other_angles(angles) : angles;
}

}  // namespace mariotte
