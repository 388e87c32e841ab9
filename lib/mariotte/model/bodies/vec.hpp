// Vectors of the plane and of space, and what turns them: a number in the plane, a vector in space.
#pragma once
#include <array>
#include <cmath>
#include <type_traits>

#include "mariotte/core/types.hpp"
#include "mariotte/core/vector3.hpp"

namespace mariotte::model {

/// n components: numbers, or values with slopes.
template <class T, int n>
struct Vec {
  std::array<T, n> at{};

  T& operator[](int i) { return at[i]; }
  const T& operator[](int i) const { return at[i]; }
};

/// Spins, moments and angular momenta: one component in the plane, three in space.
constexpr int turns(int dimension) {
  return dimension == 2 ? 1 : 3;
}
template <class T, int D>
using Turn = Vec<T, turns(D)>;

template <class T, int n>
Vec<T, n> operator+(const Vec<T, n>& a, const Vec<T, n>& b) {
  Vec<T, n> sum;
  for (int i = 0; i < n; ++i) sum[i] = a[i] + b[i];
  return sum;
}
template <class T, int n>
Vec<T, n> operator-(const Vec<T, n>& a, const Vec<T, n>& b) {
  Vec<T, n> difference;
  for (int i = 0; i < n; ++i) difference[i] = a[i] - b[i];
  return difference;
}
template <class T, int n>
Vec<T, n> operator*(const std::type_identity_t<T>& s, const Vec<T, n>& a) {
  Vec<T, n> product;
  for (int i = 0; i < n; ++i) product[i] = s * a[i];
  return product;
}
/// a · b.
template <class T, int n>
T dot(const Vec<T, n>& a, const Vec<T, n>& b) {
  T sum = a[0] * b[0];
  for (int i = 1; i < n; ++i) sum = sum + a[i] * b[i];
  return sum;
}
/// Length; 0, with no slopes, of what is zero.
template <class T, int n>
T norm(const Vec<T, n>& a) {
  using std::sqrt;
  const T square = dot(a, a);
  return square > 0.0 ? T(sqrt(square)) : T(0.0);
}

/// ω × r.
template <class T>
Vec<T, 2> turned(const Vec<T, 1>& spin, const Vec<T, 2>& r) {
  return {{-spin[0] * r[1], spin[0] * r[0]}};
}
template <class T>
Vec<T, 3> turned(const Vec<T, 3>& spin, const Vec<T, 3>& r) {
  return {
      {spin[1] * r[2] - spin[2] * r[1], spin[2] * r[0] - spin[0] * r[2], spin[0] * r[1] - spin[1] * r[0]}};
}
/// r × F.
template <class T>
Vec<T, 1> moment(const Vec<T, 2>& r, const Vec<T, 2>& force) {
  return {{r[0] * force[1] - r[1] * force[0]}};
}
template <class T>
Vec<T, 3> moment(const Vec<T, 3>& r, const Vec<T, 3>& force) {
  return turned(r, force);
}

/// The same numbers as another kind of number.
template <class T, class N, int n>
Vec<T, n> lift(const Vec<N, n>& a) {
  Vec<T, n> result;
  for (int i = 0; i < n; ++i) result[i] = T(a[i]);
  return result;
}
/// n components of a state from `place` on.
template <int n, class T>
Vec<T, n> vec_at(std::span<const T> x, Index place) {
  Vec<T, n> result;
  for (int i = 0; i < n; ++i) result[i] = x[place + i];
  return result;
}
template <class T, int n>
void put(std::span<T> x, Index place, const Vec<T, n>& v) {
  for (int i = 0; i < n; ++i) x[place + i] = v[i];
}

/// The first components of a vector of space, and back.
template <int n>
Vec<double, n> vec(const Vector3& v) {
  const std::array<double, 3> all{v.e1, v.e2, v.e3};
  Vec<double, n> result;
  for (int i = 0; i < n; ++i) result[i] = all[i];
  return result;
}
inline Vector3 vector3(const Vec<double, 2>& v) {
  return {v[0], v[1], 0};
}
inline Vector3 vector3(const Vec<double, 3>& v) {
  return {v[0], v[1], v[2]};
}
inline Vector3 vector3(const Vec<double, 1>& turn) {
  return {0, 0, turn[0]};
}

}  // namespace mariotte::model
