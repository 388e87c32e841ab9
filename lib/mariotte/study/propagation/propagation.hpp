// How uncertain the outcome of a scene is whose numbers are known to standard deviations: to first order, by
// exact slopes, and by runs with random numbers.
#pragma once
#include <cstdint>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/study/propagation/uncertain_inputs.hpp"

namespace mariotte::study {

/// Runs whose inputs are drawn from normal distributions, each by itself.
struct Samples {
  Index count = 0;
  std::uint64_t seed = 1;
};

/// One outcome [SI].
struct UncertainOutcome {
  std::string name;  ///< "velocity[0]", "time"
  std::string unit;
  std::optional<double> value;                              ///< where all inputs have theirs
  std::optional<double> deviation;                          ///< √Σ (slope · deviation)², to first order
  std::vector<std::optional<double>> share = {};            ///< of its square, by input
  std::optional<double> mean = {}, sampled_deviation = {};  ///< of the samples
};

struct Propagation {
  hybrid::Ending ending;
  std::string message;  ///< why, for endings other than separated
  std::vector<UncertainInput> inputs;
  std::vector<UncertainOutcome> outcomes;
  Samples samples;
  Index others = 0;  ///< samples that make no sense, end in another way or have other contacts: left out
  std::vector<std::string> notes;
};

/// Of a document whose uncertain inputs have been taken; of all outcomes, or of those that are asked for, as
/// "velocity[0]", "icr" or "capture_velocity". Throws as `sensitivity` and `keep_asked_for`.
Propagation propagate(const scene::Document& document, const scene::Scene& scene,
                      const std::vector<UncertainInput>& inputs, const Samples& samples,
                      const std::vector<std::string>& of = {});

}  // namespace mariotte::study
