// Vectors and quaternions within a state.
#pragma once
#include "mariotte/core/quaternion.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte {

/// Three components of a state from `place` on.
inline Vector3 vector_at(ConstState x, Index place) {
  return {x[place], x[place + 1], x[place + 2]};
}
/// Four components of a state from `place` on.
inline Quaternion quaternion_at(ConstState x, Index place) {
  return {x[place], x[place + 1], x[place + 2], x[place + 3]};
}
/// Writes three components of a state from `place` on.
inline void put(State x, Index place, const Vector3& v) {
  x[place] = v.e1;
  x[place + 1] = v.e2;
  x[place + 2] = v.e3;
}
/// Writes four components of a state from `place` on.
inline void put(State x, Index place, const Quaternion& q) {
  x[place] = q.w;
  x[place + 1] = q.x;
  x[place + 2] = q.y;
  x[place + 3] = q.z;
}

}  // namespace mariotte
