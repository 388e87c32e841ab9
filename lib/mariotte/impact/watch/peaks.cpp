#include "mariotte/impact/watch/peaks.hpp"

#include "mariotte/core/bracket.hpp"

namespace mariotte::impact {

void PeakObserver::begin(const model::ContactPhase& phase) {
  phase_ = &phase;
  peaks_.assign(phase.contacts(), {});
  damped_ = false;
  for (Index j = 0; j < phase.contacts(); ++j) damped_ = damped_ || phase.is_damped(j);
  for (auto* workspace : {&inside_, &rate_, &rate_before_, &rate_after_}) workspace->resize(phase.size());
}

void PeakObserver::differentiate(ConstState x, State dx) const {
  if (damped_) phase_->derivative(x, dx);
}

PeakObserver::Slopes PeakObserver::slopes(ConstState x, ConstState dx, Index j) const {
  const auto force = phase_->force(x, j);
  const double speed = phase_->approach(x, j);
  if (!phase_->is_damped(j)) return {speed, force.by_indentation * speed};
  return {speed, force.by_indentation * speed + force.by_rate * phase_->approach(dx, j)};
}

void PeakObserver::take(ConstState x, Index j) {
  const Peak now{.force = phase_->force(x, j).value, .indentation = -phase_->gap(x, j)};
  raise(peaks_[j], now, all_peaks);
}

void PeakObserver::search(const flow::Step& step, Index j, double Slopes::*slope, const Slopes& before,
                          const Slopes& after) {
  if (!(before.*slope > 0 && after.*slope < 0)) return;
  const auto slope_at = [&](double time) {
    step.at(time, inside_);
    differentiate(inside_, rate_);
    return slopes(inside_, rate_, j).*slope;
  };
  const double time = locate_sign_change(slope_at, step.start, before.*slope, step.end, after.*slope,
                                         1e-6 * (step.end - step.start));
  step.at(time, inside_);
  take(inside_, j);
}

void PeakObserver::observe(const flow::Step& step) {
  differentiate(step.before, rate_before_);
  differentiate(step.after, rate_after_);
  for (Index j = 0; j < std::ssize(peaks_); ++j) {
    if (!contact::carries_force(phase_->mode()[j])) continue;
    take(step.before, j);
    take(step.after, j);
    const auto before = slopes(step.before, rate_before_, j), after = slopes(step.after, rate_after_, j);
    search(step, j, &Slopes::indentation, before, after);
    if (phase_->is_damped(j)) search(step, j, &Slopes::force, before, after);
  }
}

}  // namespace mariotte::impact
