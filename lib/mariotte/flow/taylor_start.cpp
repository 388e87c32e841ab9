#include "mariotte/flow/taylor_start.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow::taylor {

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
  } else {
    double sum = d[k];
    for (int j = 1; j < k; ++j) sum -= s[j] * s[k - j];
    s[k] = sum / (2 * s[0]);
  }
  double product = 0;
  for (int j = 0; j <= k; ++j) product += d[j] * s[k - j];
  force_[lane][k] = lanes_->stiffness[lane] * product;
}

double Start::expand(const Lanes& lanes, const Part* part, int order, double tolerance) {
  lanes_ = &lanes;
  order_ = order;
  std::copy_n(part, lanes.count, part_);
  pressed_ = std::count(part, part + lanes.count, Part::pressed) > 0;
  power_ = pressed_ ? 1.25 : 2.5;
  const int shift = pressed_ ? 2 : 1;
  double last = 0;  // size of the highest coefficients
  for (int k = 0; k <= order; ++k) {
    for (int j = 0; j < lanes.count; ++j) {
      if (part_[j] != Part::struck) continue;
      const double push = pushes(j, Part::struck, k - shift, force_) + pushes(j, Part::pressed, k - 5, force_);
      rate_[j][k] = k == 0 ? lanes.rate[j] : push / (power_ * k);
      indentation_[j][k] = rate_[j][k] / (1 + power_ * k);
      next_force(j, k);
      if (k + 3 > order) last = std::max(last, std::abs(rate_[j][k]));
    }
    for (int j = 0; pressed_ && j < lanes.count; ++j) {
      if (part_[j] != Part::pressed) continue;
      const double push = pushes(j, Part::struck, k, force_) + pushes(j, Part::pressed, k - 3, force_);
      rate_[j][k] = push / (2.5 + power_ * k);
      indentation_[j][k] = rate_[j][k] / (3.5 + power_ * k);
      next_force(j, k);
      if (k + 3 > order) last = std::max(last, std::abs(rate_[j][k]));
    }
  }
  return std::pow(tolerance / std::max(last, 1e-300), 1 / (power_ * order));
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
      return l.side[lane] < 0 ? l.level[lane] - l.indentation[lane] - std::fmax(0.0, l.rate[lane]) * time - given
                              : 0;
  }
  return 0;
}

void Start::evaluate(double time, Values& values) const {
  const auto& l = *lanes_;
  const double half = std::sqrt(time), quarter = std::sqrt(half), square = time * time;
  const double z = pressed_ ? time * quarter : square * half;
  double travel[lane_limit + 2] = {};  // ∫∫ f dt dt of lane j at j + 1
  for (int j = 0; j < l.count; ++j) {
    values.impulse[j] = 0;
    if (part_[j] == Part::passive) continue;
    const double first = part_[j] == Part::struck ? 2.5 : 6.25;
    double p = 0, q = 0;
    for (int k = order_; k >= 0; --k) {
      const double term = force_[j][k] / (first + power_ * k);
      p = p * z + term;
      q = q * z + term / (first + 1 + power_ * k);
    }
    values.impulse[j] = square * (part_[j] == Part::struck ? half : square * square * quarter) * p;
    travel[j + 1] = time * square * (part_[j] == Part::struck ? half : square * square * quarter) * q;
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
