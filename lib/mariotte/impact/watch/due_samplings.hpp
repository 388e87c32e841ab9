// The samplings of a run, each at its own times.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "mariotte/core/instant.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/flow/flow.hpp"
#include "mariotte/impact/watch/observers.hpp"

namespace mariotte::impact {

/// Times are dimensionless. What is `read` has velocity(i), gap(j) and force(j), dimensionless.
class DueSamplings {
 public:
  /// For a run with so many velocities and the natural times of its contacts. Throws InvalidParameter for
  /// places that do not exist. Scale and observers must outlive this.
  DueSamplings(const RunObserver& observers, const Scale& scale, Index velocities,
               std::span<const double> contact_times);

  /// Of the next sample; infinite if there are no samplings.
  double next() const;
  template <class Run>
  void take_due(double time, Run&& read) {
    for (std::size_t i = 0; i < next_.size(); ++i)
      if (next_[i].value <= time) take(i, time, read);
  }
  template <class Run>
  void take_all(double time, Run&& read) {
    for (std::size_t i = 0; i < next_.size(); ++i) take(i, time, read);
  }
  /// Those due within a step of a phase that began at `start`; `read(x)` reads a state.
  template <class Read>
  void take_within(double start, const flow::Step& step, Read&& read) {
    for (double time = next(); time < start + step.end; time = next()) {
      inside_.resize(step.before.size());
      step.at(std::max(time - start, step.start), inside_);
      take_due(time, read(inside_));
    }
  }

 private:
  template <class Run>
  void take(std::size_t which, double time, Run& read) {
    const auto& chosen = observers_.samplings[which];
    sample_.time = time * scale_.time;
    sample_.velocity.clear();
    sample_.gap.clear();
    sample_.force.clear();
    for (const Index i : chosen.velocities) sample_.velocity.push_back(read.velocity(i) * scale_.velocity);
    for (const Index j : chosen.contacts) {
      sample_.gap.push_back(read.gap(j) * scale_.length);
      sample_.force.push_back(read.force(j) * scale_.force());
    }
    give(which);
  }
  void give(std::size_t which);

  const RunObserver& observers_;
  const Scale& scale_;
  std::vector<Instant> next_;  ///< of each sampling
  Sample sample_;
  std::vector<double> inside_;
};

}  // namespace mariotte::impact
