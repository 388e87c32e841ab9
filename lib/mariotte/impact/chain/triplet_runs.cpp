#include "mariotte/impact/chain/triplet_runs.hpp"

#include <algorithm>
#include <utility>

#include "mariotte/impact/promise.hpp"

namespace mariotte::impact {
namespace {

constexpr double attainable = Passage{}.attainable;

Passage passage(const flow::Triplet& t) {
  return {.contacts = 2,
          .harmless = single_wave(2),
          .periods = t.periods[0] + t.periods[1],
          .steps = t.steps + t.series_steps,
          .flight = t.flight};
}

}  // namespace

void TripletRuns::add(const TripletScene& scene, double accuracy) {
  accuracy_ = accuracy;
  scene_.push_back(scene);
  triplet_.push_back(dimensionless(scene, accuracy));
}

void TripletRuns::clear() {
  scene_.clear();
  triplet_.clear();
  tighter_.clear();
  again_.clear();
}

void TripletRuns::follow() {
  lanes_.follow(triplet_, accuracy_);
  follow_tighter();
}

/// Those whose errors may have grown.
void TripletRuns::follow_tighter() {
  finer_ = next_accuracy(accuracy_, accuracy_, accuracy_, attainable).value_or(accuracy_);
  for (std::size_t i = 0; i < triplet_.size(); ++i) {
    if (!may_have_erred(passage(triplet_[i]))) continue;
    again_.push_back(i);
    tighter_.push_back(dimensionless(scene_[i], finer_));
  }
  lanes_.follow(tighter_, finer_);
}

const BriefImpact* TripletRuns::result(std::size_t i) {
  const auto described = [&](const flow::Triplet& triplet, double accuracy) {
    return describe(scene_[i], triplet, accuracy, impact_);
  };
  if (!described(triplet_[i], accuracy_)) return nullptr;
  const auto again = std::lower_bound(again_.begin(), again_.end(), i);
  if (again == again_.end() || *again != i) return &impact_;
  std::swap(impact_, looser_);
  if (!(finer_ < accuracy_) || !described(tighter_[again - again_.begin()], finer_)) return nullptr;
  const double apart = difference(impact_.velocity, looser_.velocity, scene_[i].speed);
  if (apart > 0) impact_.estimated_accuracy = apart;
  return apart <= accuracy_ && !hides_rounding(passage(triplet_[i]), accuracy_) ? &impact_ : nullptr;
}

}  // namespace mariotte::impact
