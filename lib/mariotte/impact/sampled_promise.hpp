// The promise of an accuracy where runs are sampled: what was sampled cannot be taken back, so tighter runs
// are looked at only once it is clear which of them stays.
#pragma once
#include <utility>

#include "mariotte/impact/promise.hpp"
#include "mariotte/impact/watch/observers.hpp"

namespace mariotte::impact {

inline RunObserver without_samples(RunObserver observers) {
  observers.samplings.clear();
  return observers;
}

/// All samples come anew.
inline void restart(const RunObserver& observers) {
  for (const auto& sampling : observers.samplings)
    if (sampling.restart) sampling.restart();
}

/// As `keep_promise` of whole results, of which `impact` is the first and says at which accuracy it was run;
/// `run(model, options, observers)` makes one. Samples are those of the run that stays, which is run twice
/// unless it is the first.
template <class Model, class Impact, class Run, class Apart>
void keep_promise(const Model& model, const hybrid::Options& asked, const Passage& gone,
                  const RunObserver& observers, Impact& impact, Run&& run, Apart&& apart) {
  const auto quiet = without_samples(observers);
  const auto again = [&](const Model& same, const hybrid::Options& tighter) {
    return run(same, tighter, quiet);
  };
  keep_promise(model, asked, gone, impact, again, apart);
  if (observers.samplings.empty() || impact.requested_accuracy == asked.accuracy) return;
  auto stays = asked;
  stays.accuracy = impact.requested_accuracy;
  restart(observers);
  const auto estimate = impact.estimated_accuracy;
  impact = run(model, stays, observers);
  impact.estimated_accuracy = estimate;
}

}  // namespace mariotte::impact
