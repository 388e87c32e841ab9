// How fast forces make bodies is known once they have acted: what holds a body against a force keeps it far
// slower than it would fly. The accuracy is relative to speeds that are reached.
//
//   speed ← what drives would do to free bodies until the end
//   repeat
//     run roughly, and look at the velocities
//     speed ← three times the largest, but no less than such a run can tell
//     they came near the speed before, or it does not fall any more? done
#pragma once
#include <algorithm>
#include <cmath>
#include <numeric>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/model/drives/drive.hpp"

namespace mariotte::impact {

/// Collects the largest speed of `velocities` at some instants until a time.
inline Sampling sample_speeds(std::size_t velocities, double until, double& largest) {
  constexpr int looks = 200;
  Sampling sampling{.take = [&largest, until](const Sample& sample) {
    for (const double v : sample.velocity) largest = std::max(largest, std::abs(v));
    return until / looks;
  }};
  sampling.velocities.resize(velocities);
  std::iota(sampling.velocities.begin(), sampling.velocities.end(), Index{0});
  return sampling;
}

/// A driven chain or network that knows which speeds are reached; `run(model, options, observers)` makes a
/// result without a promise. Motions are known before.
template <class Model, class Run>
Model with_reached_speeds(Model model, const hybrid::Options& options, const RunObserver& observers,
                          Run&& run) {
  constexpr double near = 0.1, accuracy = 1e-6, told = 1e-3;
  constexpr int most_runs = 8;
  for (auto& drive : model.drive) drive.until = options.max_time;
  auto roughly = options;
  roughly.accuracy = accuracy;
  const auto pushes = [](const model::Drive& drive) { return drive.quantity == model::Driven::force; };
  double speed = reference_speed(model);
  bool falls = std::any_of(model.drive.begin(), model.drive.end(), pushes);
  for (int i = 0; falls && i < most_runs; ++i) {
    double largest = 0;
    run(model, roughly,
        RunObserver{.samplings = {sample_speeds(model.velocity.size(), options.max_time, largest)},
                    .progress = observers.progress,
                    .gives_up = observers.gives_up});
    for (auto& drive : model.drive)
      drive.reached = std::min(drive.reached, std::max(3 * largest, told * speed));
    const double now = reference_speed(model);
    falls = largest < near * speed && now < 0.5 * speed;
    speed = now;
  }
  return model;
}

}  // namespace mariotte::impact
