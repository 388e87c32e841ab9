// Vectors and quaternions within a state.
#pragma once
#include "mariotte/core/quaternion.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte {

/// Three components of a state from `place` on.
template <class T = double>
BasicVector3<T> vector_at(std::type_identity_t<std::span<const T>> x, Index place) {
  return {x[place], x[place + 1], x[place + 2]};
}
/// Four components of a state from `place` on.
template <class T = double>
BasicQuaternion<T> quaternion_at(std::type_identity_t<std::span<const T>> x, Index place) {
  return {x[place], x[place + 1], x[place + 2], x[place + 3]};
}
/// Writes three components of a state from `place` on.
template <class T>
void put(std::type_identity_t<std::span<T>> x, Index place, const BasicVector3<T>& v) {
  x[place] = v.e1;
  x[place + 1] = v.e2;
  x[place + 2] = v.e3;
}
/// Writes four components of a state from `place` on.
template <class T>
void put(std::type_identity_t<std::span<T>> x, Index place, const BasicQuaternion<T>& q) {
  x[place] = q.w;
  x[place + 1] = q.x;
  x[place + 2] = q.y;
  x[place + 3] = q.z;
}

}  // namespace mariotte
