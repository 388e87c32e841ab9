#include "mariotte/impact/chain/row_runs.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "mariotte/impact/promise.hpp"

namespace mariotte::impact {
namespace {

constexpr double attainable = Passage{}.attainable;

template <int most>
bool starts_slowly(const RowScene<most>& scene, double accuracy) {
  for (int j = 0; j < scene.contacts(); ++j)
    if (is_slow(scene.velocity[j] - scene.velocity[j + 1], accuracy, scene.speed)) return true;
  return false;
}

template <int most, class Row>
Passage passage(const RowScene<most>& scene, const Row& row, double accuracy) {
  const Index contacts = scene.contacts();
  return {.contacts = contacts,
          .harmless = single_wave(contacts),
          .periods = std::accumulate(row.periods, row.periods + contacts, Index(0)),
          .most = *std::max_element(row.periods, row.periods + contacts),
          .steps = row.steps + row.series_steps,
          .flight = row.flights.longest(),
          .starts_slowly = starts_slowly(scene, accuracy)};
}

}  // namespace

template <int most, class Lanes, class Row>
void RowRuns<most, Lanes, Row>::add(const Scene& scene, double accuracy) {
  accuracy_ = accuracy;
  scene_.push_back(scene);
  row_.push_back(dimensionless(scene, accuracy));
}

template <int most, class Lanes, class Row>
void RowRuns<most, Lanes, Row>::clear() {
  scene_.clear();
  row_.clear();
  tighter_.clear();
  again_.clear();
}

template <int most, class Lanes, class Row>
void RowRuns<most, Lanes, Row>::follow() {
  lanes_.follow(row_, accuracy_);
  follow_tighter();
}

/// Those whose errors may have grown.
template <int most, class Lanes, class Row>
void RowRuns<most, Lanes, Row>::follow_tighter() {
  finer_ = next_accuracy(accuracy_, accuracy_, accuracy_, attainable).value_or(accuracy_);
  for (std::size_t i = 0; i < row_.size(); ++i) {
    if (!may_have_erred(passage(scene_[i], row_[i], accuracy_))) continue;
    again_.push_back(i);
    tighter_.push_back(dimensionless(scene_[i], finer_));
  }
  lanes_.follow(tighter_, finer_);
}

template <int most, class Lanes, class Row>
const BriefImpact* RowRuns<most, Lanes, Row>::result(std::size_t i) {
  const auto& scene = scene_[i];
  const auto described = [&](const Row& row, double accuracy) {
    return describe(scene, row, accuracy, impact_);
  };
  if (!described(row_[i], accuracy_)) return nullptr;
  const auto again = std::lower_bound(again_.begin(), again_.end(), i);
  if (again == again_.end() || *again != i) return &impact_;
  std::swap(impact_, looser_);
  if (!(finer_ < accuracy_) || !described(tighter_[again - again_.begin()], finer_)) return nullptr;
  const double apart = difference(impact_.velocity, looser_.velocity, scene.speed);
  if (apart > 0) impact_.estimated_accuracy = apart;
  const bool agrees =
      apart <= agreement * accuracy_ && !hides_rounding(passage(scene, row_[i], accuracy_), accuracy_);
  return agrees ? &impact_ : nullptr;
}

template class RowRuns<3, flow::Triplets, flow::Triplet>;
template class RowRuns<flow::ShortRow::most + 1, flow::ShortRows, flow::ShortRow>;

}  // namespace mariotte::impact
