#include "mariotte/impact/watch/peaks.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/bracket.hpp"

namespace mariotte::impact {

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
  const double depth = -phase_->gap(x, j);
  if (depth <= peaks_[j].indentation && !phase_->is_damped(j)) return;  // nor is the force larger
  raise(peaks_[j], Peak{.force = phase_->force(x, j).value, .indentation = depth}, all_peaks);
}

/// A slope of a millionth of that at both ends of the step is near enough: the value is flat there.
template <class Slope>
void PeakObserver::search(const flow::Step& step, Index j, double before, double after, Slope&& slope) {
  constexpr double near = 1e-6;
  if (!(before > 0 && after < 0)) return;
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

void PeakObserver::search_indentation(const flow::Step& step, Index j) {
  search(step, j, phase_->approach(step.before, j), phase_->approach(step.after, j),
         [&](ConstState x) { return phase_->approach(x, j); });
}

void PeakObserver::search_force(const flow::Step& step, Index j) {
  search(step, j, force_slope(step.before, rate_before_, j), force_slope(step.after, rate_after_, j),
         [&](ConstState x) {
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
