#include "mariotte/impact/peaks.hpp"

#include <algorithm>

#include "mariotte/core/bracket.hpp"

namespace mariotte::impact {

void PeakWatcher::begin(const model::ChainPhase& phase, const model::ChainLayout& layout) {
  phase_ = &phase;
  layout_ = &layout;
  peaks_.assign(layout.contacts(), {});
  inside_.resize(layout.size);
  rate_.resize(layout.size);
}

PeakWatcher::Slopes PeakWatcher::slopes(ConstState x, Index j) {
  const Index left = layout_->velocity[j], right = layout_->velocity[j + 1];
  const auto force = phase_->force(x, j);
  const double speed = x[left] - x[right];
  if (layout_->work[j] == model::ChainLayout::absent) return {speed, force.by_indentation * speed};
  phase_->derivative(x, rate_);
  return {speed, force.by_indentation * speed + force.by_rate * (rate_[left] - rate_[right])};
}

void PeakWatcher::take(ConstState x, Index j) {
  auto& peak = peaks_[j];
  peak.force = std::max(peak.force, phase_->force(x, j).value);
  peak.indentation = std::max(peak.indentation, -x[layout_->gap[j]]);
}

void PeakWatcher::search(const flow::Step& step, Index j, double Slopes::*slope, const Slopes& before,
                         const Slopes& after) {
  if (!(before.*slope > 0 && after.*slope < 0)) return;
  const auto slope_at = [&](double time) {
    step.at(time, inside_);
    return slopes(inside_, j).*slope;
  };
  const double time = locate_sign_change(slope_at, step.start, before.*slope, step.end, after.*slope,
                                         1e-6 * (step.end - step.start));
  step.at(time, inside_);
  take(inside_, j);
}

void PeakWatcher::watch(const flow::Step& step) {
  for (Index j = 0; j < layout_->contacts(); ++j) {
    if (!contact::carries_force(phase_->mode()[j])) continue;
    take(step.before, j);
    take(step.after, j);
    const auto before = slopes(step.before, j), after = slopes(step.after, j);
    search(step, j, &Slopes::indentation, before, after);
    if (layout_->work[j] != model::ChainLayout::absent) search(step, j, &Slopes::force, before, after);
  }
}

}  // namespace mariotte::impact
