#include "mariotte/flow/taylor/taylor_start.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/rough_root.hpp"

namespace mariotte::flow::taylor {
namespace {

/// 1/(first + q k), the factors of integration in z = t^q.
struct Reciprocals {
  double of[order_limit + 1];
  constexpr Reciprocals(double first, double power) : of{} {
    for (int k = 0; k <= order_limit; ++k) of[k] = first + power * k > 0 ? 1 / (first + power * k) : 0;
  }
};

/// Of δ̇ and δ of struck contacts, and of their impulse and its integral; then of pressed ones.
struct Integrals {
  Reciprocals rate, indentation, impulse, travel, pressed_impulse, pressed_travel;
  constexpr explicit Integrals(double q)
      : rate(0, q),
        indentation(1, q),
        impulse(2.5, q),
        travel(3.5, q),
        pressed_impulse(6.25, q),
        pressed_travel(7.25, q) {}
};
constexpr Integrals with_pressed(1.25), all_struck(2.5);

}  // namespace

/// Σ over the neighbours and the lane itself of (coupling) e_k, of the lanes of one part.
double Start::pushes(int lane, Part from, int k, const Coefficients* force) const {
  if (k < 0) return 0;
  const auto& l = *lanes_;
  double sum = 0;
  if (lane > 0 && part_[lane - 1] == from) sum += l.left[lane] * force[lane - 1][k];
  if (lane + 1 < l.count && part_[lane + 1] == from) sum += l.right[lane] * force[lane + 1][k];
  if (part_[lane] == from) sum -= (l.left[lane] + l.right[lane]) * force[lane][k];
  return sum;
}

/// e_k = k (d √d)_k.
void Start::next_force(int lane, int k) {
  const auto& d = indentation_[lane];
  auto& s = root_[lane];
  if (k == 0) {
    s[0] = std::sqrt(d[0]);
    half_inverse_[lane] = 0.5 / s[0];
    force_[lane][0] = lanes_->stiffness[lane] * d[0] * s[0];
    return;
  }
  const double middle = k % 2 == 0 ? s[k / 2] : 0;
  double twice = 0, left = 0, right = d[k] * s[0];  // sums that do not wait for each other
  for (int j = 1; 2 * j < k; ++j) {
    twice += s[j] * s[k - j];
    left += d[j] * s[k - j];
    right += d[k - j] * s[j];
  }
  if (k % 2 == 0) left += d[k / 2] * middle;
  s[k] = (d[k] - 2 * twice - middle * middle) * half_inverse_[lane];
  force_[lane][k] = lanes_->stiffness[lane] * (left + right + d[0] * s[k]);
}

double Start::expand(const Lanes& lanes, const Part* part, int order, double tolerance) {
  lanes_ = &lanes;
  order_ = order;
  std::copy_n(part, lanes.count, part_);
  pressed_ = std::count(part, part + lanes.count, Part::pressed) > 0;
  power_ = pressed_ ? 1.25 : 2.5;
  const int shift = pressed_ ? 2 : 1;
  const auto& integral = pressed_ ? with_pressed : all_struck;
  double last = 0;  // size of the highest coefficients
  for (int k = 0; k <= order; ++k) {
    for (int j = 0; j < lanes.count; ++j) {
      if (part_[j] != Part::struck) continue;
      const double push =
          pushes(j, Part::struck, k - shift, force_) + pushes(j, Part::pressed, k - 5, force_);
      rate_[j][k] = k == 0 ? lanes.rate[j] : push * integral.rate.of[k];
      indentation_[j][k] = rate_[j][k] * integral.indentation.of[k];
      next_force(j, k);
      if (k + 3 > order) last = std::max(last, std::abs(rate_[j][k]));
    }
    for (int j = 0; pressed_ && j < lanes.count; ++j) {
      if (part_[j] != Part::pressed) continue;
      const double push = pushes(j, Part::struck, k, force_) + pushes(j, Part::pressed, k - 3, force_);
      rate_[j][k] = push * integral.impulse.of[k];
      indentation_[j][k] = rate_[j][k] * integral.travel.of[k];
      next_force(j, k);
      if (k + 3 > order) last = std::max(last, std::abs(rate_[j][k]));
    }
  }
  return rough_root(tolerance / std::max(last, 1e-300), power_ * order);
}

/// What a contact's own force takes away grows faster than what its neighbours give: if a struck contact is
/// still indented without their help, or a pressed one by half of it, they have been all the while. An open
/// gap has not closed if it would stay open with all pushes and without its own opening speed.
double Start::margin(int lane, double time, double own, double given) const {
  const auto& l = *lanes_;
  switch (part_[lane]) {
    case Part::struck:
      return l.rate[lane] * time - own;
    case Part::pressed:
      return 0.5 * given - own;
    case Part::passive:
      return l.side[lane] < 0
                 ? l.level[lane] - l.indentation[lane] - std::fmax(0.0, l.rate[lane]) * time - given
                 : 0;
  }
  return 0;
}

void Start::evaluate(double time, Values& values) const {
  const auto& l = *lanes_;
  const double half = std::sqrt(time), quarter = std::sqrt(half), square = time * time;
  const double z = pressed_ ? time * quarter : square * half;
  const auto& integral = pressed_ ? with_pressed : all_struck;
  double travel[lane_limit + 2] = {};  // ∫∫ f dt dt of lane j at j + 1
  for (int j = 0; j < l.count; ++j) {
    values.impulse[j] = 0;
    if (part_[j] == Part::passive) continue;
    const bool struck = part_[j] == Part::struck;
    const auto& once = struck ? integral.impulse : integral.pressed_impulse;
    const auto& twice = struck ? integral.travel : integral.pressed_travel;
    double p = 0, q = 0;
    for (int k = order_; k >= 0; --k) {
      const double term = force_[j][k] * once.of[k];
      p = p * z + term;
      q = q * z + term * twice.of[k];
    }
    const double size = square * (struck ? half : square * square * quarter);
    values.impulse[j] = size * p;
    travel[j + 1] = time * size * q;
  }
  for (int j = 0; j < l.count; ++j) {
    const double own = (l.left[j] + l.right[j]) * travel[j + 1];
    const double given = l.left[j] * travel[j] + l.right[j] * travel[j + 2];
    values.indentation[j] = l.indentation[j] + l.rate[j] * time + given - own;
    values.margin[j] = margin(j, time, own, given);
  }
  values.time = time;
}

}  // namespace mariotte::flow::taylor
