#include "mariotte/impact/watch/peaks.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/bracket.hpp"

namespace mariotte::impact {
namespace {

constexpr double near = 1e-6;

/// Value and slope of a power series.
struct Point {
  double value = 0, slope = 0;
};
Point at(double place, const flow::PushPolynomial& c, int order) {
  Point point;
  for (int k = order; k >= 0; --k) {
    point.slope = point.slope * place + point.value;
    point.value = point.value * place + c[k];
  }
  return point;
}

}  // namespace

void PeakObserver::begin(const model::ContactPhase& phase) {
  phase_ = &phase;
  peaks_.assign(phase.contacts(), {});
  damped_ = false;
  for (Index j = 0; j < phase.contacts(); ++j) damped_ = damped_ || phase.is_damped(j);
  for (auto* workspace : {&inside_, &rate_, &rate_before_, &rate_after_}) workspace->resize(phase.size());
}

double PeakObserver::force_slope(ConstState x, ConstState dx, Index j) const {
  const auto force = phase_->force(x, j);
  return force.by_indentation * phase_->approach(x, j) + force.by_rate * phase_->approach(dx, j);
}

void PeakObserver::take(ConstState x, Index j) {
  take(-phase_->gap(x, j), phase_->approach(x, j), j);
}

void PeakObserver::take(double depth, double rate, Index j) {
  if (depth <= peaks_[j].indentation && !phase_->is_damped(j)) return;  // nor is the force larger
  raise(peaks_[j], Peak{.force = phase_->force(depth, rate, j).value, .indentation = depth}, all_peaks);
}

/// A slope of a millionth of that at both ends of the step is near enough: the value is flat there.
template <class Slope>
void PeakObserver::search(const flow::Step& step, Index j, double before, double after, Slope&& slope) {
  double last = -1;  // fraction at which `inside_` is the state
  const auto slope_at = [&](double fraction) {
    step.inside(last = fraction, inside_);
    const double value = slope(inside_);
    return std::abs(value) < near * std::min(before, -after) ? 0 : value;
  };
  const double fraction = locate_sign_change(slope_at, 0, before, 1, after, near);
  if (fraction != last) step.inside(fraction, inside_);
  take(inside_, j);
}

/// The same in the clock of `motion_`.
template <class Slope>
void PeakObserver::search_series(Index j, double before, double after, Slope&& slope) {
  const auto& m = motion_;
  const double place = locate_sign_change(slope, 0, before, m.end, after, near * m.end);
  take(at(place, m.depth, m.order).value, at(place, m.rate, m.order).value, j);
}

void PeakObserver::search_indentation(const flow::Step& step, Index j) {
  const double before = phase_->approach(step.before, j), after = phase_->approach(step.after, j);
  if (!(before > 0 && after < 0)) return;
  if (step.indentation(phase_->gap_place(j), motion_))
    return search_series(j, before, after,
                         [&](double place) { return at(place, motion_.rate, motion_.order).value; });
  search(step, j, before, after, [&](ConstState x) { return phase_->approach(x, j); });
}

void PeakObserver::search_force(const flow::Step& step, Index j) {
  const double before = force_slope(step.before, rate_before_, j),
               after = force_slope(step.after, rate_after_, j);
  if (!(before > 0 && after < 0)) return;
  if (step.indentation(phase_->gap_place(j), motion_))
    return search_series(j, before, after, [&](double place) {
      const auto depth = at(place, motion_.depth, motion_.order),
                 rate = at(place, motion_.rate, motion_.order);
      const auto force = phase_->force(depth.value, rate.value, j);
      return force.by_indentation * depth.slope + force.by_rate * rate.slope;
    });
  search(step, j, before, after, [&](ConstState x) {
    phase_->derivative(x, rate_);
    return force_slope(x, rate_, j);
  });
}

void PeakObserver::observe(const flow::Step& step) {
  if (damped_) {
    phase_->derivative(step.before, rate_before_);
    phase_->derivative(step.after, rate_after_);
  }
  for (Index j = 0; j < std::ssize(peaks_); ++j) {
    if (!contact::carries_force(phase_->mode()[j])) continue;
    if (step.start == 0) take(step.before, j);  // else the end of the step before
    take(step.after, j);
    search_indentation(step, j);
    if (phase_->is_damped(j)) search_force(step, j);
  }
}

}  // namespace mariotte::impact
