#include "mariotte/impact/laws/linear_triplet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mariotte/core/error.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::impact {
namespace {

using Real = long double;  // roots and differences below lose some digits of what is returned
constexpr Real pi = std::numbers::pi_v<Real>;

Real versine(Real angle) {
  return 2 * std::sin(angle / 2) * std::sin(angle / 2);
}

/// An overlap a sin(ω₁ t)/ω₁ + b sin(ω₂ t)/ω₂ with a > 0, and its slope and integral.
struct Overlap {
  Real a, b, slow, fast;

  Real value(Real t) const { return a * std::sin(slow * t) / slow + b * std::sin(fast * t) / fast; }
  Real slope(Real t) const { return a * std::cos(slow * t) + b * std::cos(fast * t); }
  Real integral(Real t) const {
    return a * versine(slow * t) / (slow * slow) + b * versine(fast * t) / (fast * fast);
  }
  /// The slow sine outweighs the fast one as long as ω₁ t and π are further apart than this.
  Real window() const { return std::asin(std::abs(b) * slow / (a * fast)); }
};

/// Both overlaps with both contacts closed, m = k₁ = v₁ = 1.
struct Motion {
  Real slow, fast;
  Overlap first, second;
};

Motion motion(Real k) {
  const Real s = std::sqrt(k * k - k + 1);
  // κ+1−s, and for κ < 1 also κ−1+s, cancel; (κ+1)² − s² = 3κ and βγ = −κ do not.
  const Real slow = std::sqrt(3 * k / (k + 1 + s)), fast = std::sqrt(k + 1 + s);
  const Real beta = k > 1 ? k - 1 + s : k / (1 - k + s), gamma = -k / beta;
  return {
      slow, fast, {beta / (2 * s), -gamma / (2 * s), slow, fast}, {1 / (2 * s), -1 / (2 * s), slow, fast}};
}

/// Where the overlap, positive at `before` and not at `after`, becomes 0.
Real zero_between(const Overlap& overlap, Real before, Real after) {
  for (int i = 0; i < 70; ++i) {  // as many bits as there are
    const Real middle = (before + after) / 2;
    (overlap.value(middle) > 0 ? before : after) = middle;
  }
  return before + (after - before) / 2;
}

/// Contact 1 lets go once, simply: for κ ≤ 1 as the fast sine turns negative, for κ > 1 as the slow one does.
Real first_opens(const Motion& m, Real k) {
  if (k <= 1) return zero_between(m.first, pi / m.fast, 1.5L * pi / m.fast);
  const Real half = m.first.window();
  return zero_between(m.first, (pi - half) / m.slow, (pi + half) / m.slow);
}

/// The first of up to three zeros near π/ω₁, where the overlap is negative if contact 2 opens first. The
/// slope, cos ω₁t − cos ω₂t up to a factor, is zero at multiples of 2π/(ω₂ ± ω₁), and the overlap monotone
/// in between.
Real second_opens(const Motion& m) {
  Real before = (pi - m.second.window()) / m.slow;
  const std::array<Real, 2> spacing = {2 * pi / (m.fast + m.slow), 2 * pi / (m.fast - m.slow)};
  const auto next = [&](Real after) {
    Real nearest = pi / m.slow;
    for (const Real step : spacing) nearest = std::min(nearest, step * (std::floor(after / step) + 1));
    return nearest;
  };
  Real after = next(before);
  while (m.second.value(after) > 0 && after < pi / m.slow) {
    before = after;
    after = next(before);
  }
  return zero_between(m.second, before, after);
}

/// The contact that stays closed is alone with two balls from then on, until its own half-turn ends.
struct Parting {
  Real impulse;  ///< per unit stiffness
  Real duration;
};

Parting part(const Overlap& overlap, Real t, Real frequency) {
  const Real x = overlap.value(t), rate = overlap.slope(t);
  const Real angle = std::atan2(x * frequency, -rate);
  return {x * std::sin(angle) / frequency + rate * versine(angle) / (frequency * frequency),
          angle / frequency};
}

/// Odd and even integer parts of ω₂/ω₁ alternate. κ is known to its last digit, the frequencies not better.
FirstToOpen first_to_open(const Motion& m, Real k) {
  const Real frequencies = m.fast / m.slow, integer = std::round(frequencies);
  if (k < 1) return FirstToOpen::contact_1;
  if (std::abs(frequencies - integer) <= 4 * Real{epsilon} * integer) return FirstToOpen::both;
  return std::fmod(std::floor(frequencies), Real{2}) == 1 ? FirstToOpen::contact_1 : FirstToOpen::contact_2;
}

/// The first instant at which a contact opens.
Real opens(const Motion& m, Real k, FirstToOpen first) {
  if (first == FirstToOpen::both) return pi / m.slow;
  return first == FirstToOpen::contact_1 ? first_opens(m, k) : second_opens(m);
}

void expect_integer(int j) {
  if (j < 2) throw InvalidParameter("the frequency ratio of three balls is at least √3: j must be 2 or more");
}

/// s/(κ+1) of the integer j.
Real reach(int j) {
  const Real square = Real{1} * j * j;
  return (square - 1) / (square + 1);
}

}  // namespace

LinearTripletImpact linear_triplet(const LinearTriplet& triplet) {
  for (const double value : {triplet.mass, triplet.stiffness, triplet.ratio, triplet.speed})
    if (!(value > 0) || !std::isfinite(value))
      throw InvalidParameter("mass, stiffness, ratio and speed of a triplet must be positive and finite");
  const Real k = triplet.ratio;
  const auto m = motion(k);
  const auto first = first_to_open(m, k);
  const Real t = opens(m, k, first);
  Real p1 = m.first.integral(t), p2 = k * m.second.integral(t);
  std::array<Real, 2> end = {t, t};
  if (first == FirstToOpen::contact_1) {
    const auto rest = part(m.second, t, std::sqrt(2 * k));
    p2 += k * rest.impulse;
    end[1] += rest.duration;
  } else if (first == FirstToOpen::contact_2) {
    const auto rest = part(m.first, t, std::sqrt(Real{2}));
    p1 += rest.impulse;
    end[0] += rest.duration;
  }
  const Real v = triplet.speed, time = std::sqrt(Real{triplet.mass} / triplet.stiffness);
  const auto in = [](Real unit, Real value) { return static_cast<double>(unit * value); };
  return {.velocity = {in(v, 1 - p1), in(v, p1 - p2), in(v, p2)},
          .impulse = {in(triplet.mass * v, p1), in(triplet.mass * v, p2)},
          .opening = {in(time, end[0]), in(time, end[1])},
          .icr = in(1, p1 / p2),
          .first = first};
}

double frequency_ratio(double stiffness_ratio) {
  const auto m = motion(stiffness_ratio);
  return static_cast<double>(m.fast / m.slow);
}

double integer_stiffness_ratio(int j) {
  expect_integer(j);
  const Real r = reach(j);
  return static_cast<double>((1 + 2 * r * r + std::sqrt(3 * (4 * r * r - 1))) / (2 * (1 - r * r)));
}

std::array<double, 3> integer_velocities(int j) {
  expect_integer(j);
  if (j % 2 == 1) return {-1.0 / 3, 2.0 / 3, 2.0 / 3};
  const Real k = integer_stiffness_ratio(j), s = reach(j) * (k + 1);
  const Real last = (1 + 1 / reach(j)) / 3, middle = last - 1 / s;
  return {static_cast<double>(1 - middle - last), static_cast<double>(middle), static_cast<double>(last)};
}

}  // namespace mariotte::impact
