// Vectors and quaternions within a state.
#pragma once
#include "mariotte/core/quaternion.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte {

inline Vector3 vector_at(ConstState x, Index place) {
  return {x[place], x[place + 1], x[place + 2]};
}
inline Quaternion quaternion_at(ConstState x, Index place) {
  return {x[place], x[place + 1], x[place + 2], x[place + 3]};
}
inline void put(State x, Index place, const Vector3& v) {
  x[place] = v.e1;
  x[place + 1] = v.e2;
  x[place + 2] = v.e3;
}
inline void put(State x, Index place, const Quaternion& q) {
  x[place] = q.w;
  x[place + 1] = q.x;
  x[place + 2] = q.y;
  x[place + 3] = q.z;
}

}  // namespace mariotte
