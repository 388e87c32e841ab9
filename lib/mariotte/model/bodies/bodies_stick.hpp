// Friction of contacts that stick rigidly: what keeps their slip as it is.
#pragma once
#include <vector>

#include "mariotte/model/bodies/bodies_motion.hpp"
#include "mariotte/model/bodies/linear_system.hpp"

namespace mariotte::model {

/// e_z × n, in the plane.
template <class T>
Vec<T, 2> across(const Vec<T, 2>& n) {
  return {{-n[1], n[0]}};
}

/// Unit vectors along the tangent plane.
template <class T>
std::array<Vec<T, 2>, 1> tangents(const Vec<T, 2>& n) {
  return {across(n)};
}
template <class T>
std::array<Vec<T, 3>, 2> tangents(const Vec<T, 3>& n) {
  int least = 0;
  for (int k = 1; k < 3; ++k)
    if (series::value_of(n[k] * n[k]) < series::value_of(n[least] * n[least])) least = k;
  auto axis = lift<T>(Vec<double, 3>{});
  axis[least] = T(1.0);
  const auto side = turned(n, axis);
  const auto one = (1.0 / norm(side)) * side;
  return {one, turned(n, one)};
}

/// One of the bodies of a contact; −1: a plane.
template <class T, int D>
struct StuckSide {
  Index body;
  Vec<T, D> lever;
  double sign;  ///< of the force on it
};

/// A contact that sticks, and how its slip would change without friction of those that do.
template <class T, int D>
struct StuckContact {
  std::array<Vec<T, D>, D - 1> tangents;
  std::array<StuckSide<T, D>, 2> side;
  Vec<T, D> slip_rate;
};

/// Acceleration along `s` at one contact by a unit force along `t` at another.
template <class T, int D, class N>
T mobility(const BodiesSetting<D, N>& setting, std::span<const BodyMotion<T, D>> motion,
           const StuckContact<T, D>& at, const Vec<T, D>& s, const StuckContact<T, D>& by,
           const Vec<T, D>& t) {
  T sum = T(0.0);
  for (const auto& one : at.side)
    for (const auto& other : by.side) {
      if (one.body != other.body || one.body < 0) continue;
      const auto& body = setting.body[one.body];
      const auto spin = eased(body, motion[one.body], moment(other.lever, t));
      const T moves = T(1 / body.mass) * dot(s, t) + dot(s, turned(spin, one.lever));
      sum = sum + one.sign * other.sign * moves;
    }
  return sum;
}

/// Sets the friction of each, from W f = −(rate of slip). False if the contacts are redundant: then it is the
/// least that does.
template <class T, int D, class N>
bool hold_still(const BodiesSetting<D, N>& setting, std::span<const BodyMotion<T, D>> motion,
                std::span<const StuckContact<T, D>> stuck, std::vector<Vec<T, D>>& friction) {
  constexpr int k = D - 1;
  const std::size_t size = k * stuck.size();
  std::vector<T> matrix(size * size, T(0.0)), right(size);
  for (std::size_t row = 0; row < size; ++row) {
    const auto& at = stuck[row / k];
    right[row] = -dot(at.slip_rate, at.tangents[row % k]);
    for (std::size_t column = 0; column < size; ++column) {
      const auto& by = stuck[column / k];
      matrix[row * size + column] =
          mobility(setting, motion, at, at.tangents[row % k], by, by.tangents[column % k]);
    }
  }
  const bool determined = solve_symmetric(std::span(matrix), std::span(right));
  friction.assign(stuck.size(), lift<T>(Vec<double, D>{}));
  for (std::size_t row = 0; row < size; ++row)
    friction[row / k] = friction[row / k] + right[row] * stuck[row / k].tangents[row % k];
  return determined;
}

}  // namespace mariotte::model
