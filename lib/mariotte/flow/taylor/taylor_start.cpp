#include "mariotte/flow/taylor/taylor_start.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/rough_root.hpp"
#include "mariotte/flow/taylor/felt.hpp"

namespace mariotte::flow::taylor {
namespace {

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

/// Σ over the lanes of one part that a lane feels of (coupling) e_k.
double Start::pushes(int lane, Part from, int k) const {
  if (k < 0) return 0;
  double sum = 0;
  for_each_felt(*lanes_, lane, [&](int other, double weight) {
    if (lane_[other].part == from) sum += weight * lane_[other].force[k];
  });
  return sum;
}

double Start::expand(const Lanes& lanes, const Part* part, int order, double tolerance) {
  lanes_ = &lanes;
  order_ = order;
  lane_.resize(std::max<std::size_t>(lane_.size(), lanes.count));
  for (int j = 0; j < lanes.count; ++j) lane_[j].part = part[j];
  pressed_ = std::count(part, part + lanes.count, Part::pressed) > 0;
  power_ = pressed_ ? 1.25 : 2.5;
  const int shift = pressed_ ? 2 : 1;
  const auto& integral = pressed_ ? with_pressed : all_struck;
  double last = 0;  // size of the highest coefficients
  const auto take = [&](int j, int k, double rate, double travel) {
    auto& own = lane_[j];
    own.rate[k] = rate;
    own.indentation[k] = rate * travel;
    own.next(k, lanes.stiffness[j]);
    if (k + 3 > order) last = std::max(last, std::abs(rate));
  };
  for (int k = 0; k <= order; ++k) {
    for (int j = 0; j < lanes.count; ++j) {
      if (part[j] != Part::struck) continue;
      const double push = pushes(j, Part::struck, k - shift) + pushes(j, Part::pressed, k - 5);
      take(j, k, k == 0 ? lanes.rate[j] : push * integral.rate.of[k], integral.indentation.of[k]);
    }
    for (int j = 0; pressed_ && j < lanes.count; ++j) {
      if (part[j] != Part::pressed) continue;
      const double push = pushes(j, Part::struck, k) + pushes(j, Part::pressed, k - 3);
      take(j, k, push * integral.impulse.of[k], integral.travel.of[k]);
    }
  }
  return std::min(rough_root(tolerance / std::max(last, 1e-300), power_ * order),
                  rough_root(safe_place(), power_));
}

/// z up to which no depth has a zero, and so its root a series: Σ |d_k| zᵏ < d_0 over k > 0. What is pressed
/// hardly at first, and more by others later, has one near 0, and the series of its force needs more orders
/// to show it than there are.
double Start::safe_place() const {
  double most = 0;
  for (int j = 0; j < lanes_->count; ++j) {
    const auto& d = lane_[j].indentation;
    for (int k = 1; lane_[j].part != Part::passive && k <= order_; ++k)
      if (d[k] != 0) most = std::max(most, rough_root(std::abs(d[k] / d[0]), k));
  }
  return most > 0 ? 0.5 / most : infinity;
}

/// Those of pressed contacts begin with t^{7/2} = t z² and t^{7/4} = √t z.
void Start::coefficients(int lane, std::span<double> indentation, std::span<double> root) const {
  const auto& own = lane_[lane];
  const int later = own.part == Part::pressed ? 1 : 0;
  for (int k = 0; k <= order_; ++k) {
    indentation[k] = k >= 2 * later ? own.indentation[k - 2 * later] : 0;
    root[k] = k >= later ? own.root[k - later] : 0;
  }
}

/// What a contact's own force takes away grows faster than what the others give: if a struck contact is still
/// indented without what they give, or a pressed one by half of it, they have been all the while. Pushes
/// grow, so an open gap falls faster and faster: if all pushes leave it open, it has been all the while.
double Start::margin(int lane, double time, const Travel& travel) const {
  const auto& l = *lanes_;
  switch (lane_[lane].part) {
    case Part::struck:
      return l.rate[lane] * time - travel.drawn - travel.own;
    case Part::pressed:
      return 0.5 * travel.given - travel.drawn - travel.own;
    case Part::passive:
      return l.side[lane] < 0 ? l.level[lane] - l.indentation[lane] - l.rate[lane] * time - travel.given : 0;
  }
  return 0;
}

/// Impulses, and their integrals.
void Start::sweep(double time, Values& values) const {
  const double half = std::sqrt(time), quarter = std::sqrt(half), square = time * time;
  const double z = pressed_ ? time * quarter : square * half;
  const auto& integral = pressed_ ? with_pressed : all_struck;
  swept_.assign(lanes_->count, 0);
  for (int j = 0; j < lanes_->count; ++j) {
    values.impulse[j] = 0;
    if (lane_[j].part == Part::passive) continue;
    const bool struck = lane_[j].part == Part::struck;
    const auto& once = struck ? integral.impulse : integral.pressed_impulse;
    const auto& twice = struck ? integral.travel : integral.pressed_travel;
    double p = 0, q = 0;
    for (int k = order_; k >= 0; --k) {
      const double term = lane_[j].force[k] * once.of[k];
      p = p * z + term;
      q = q * z + term * twice.of[k];
    }
    const double size = square * (struck ? half : square * square * quarter);
    values.impulse[j] = size * p;
    swept_[j] = time * size * q;
  }
}

void Start::evaluate(double time, Values& values) const {
  const auto& l = *lanes_;
  sweep(time, values);
  for (int j = 0; j < l.count; ++j) {
    Travel travel;
    for_each_felt(l, j, [&](int other, double weight) {
      const double part = weight * swept_[other];
      if (other == j)
        travel.own -= part;
      else
        (part > 0 ? travel.given : travel.drawn) += std::abs(part);
    });
    values.indentation[j] = l.indentation[j] + l.rate[j] * time + (travel.given - travel.drawn) - travel.own;
    values.margin[j] = margin(j, time, travel);
  }
  values.time = time;
  values.may_fall = false;
  values.is_deep = values.may_change = true;
}

}  // namespace mariotte::flow::taylor
