#include "mariotte/study/propagation/propagation.hpp"

#include <cmath>

#include "mariotte/study/sensitivity/scene_parameters.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::study {
namespace {

UncertainOutcome first_order(const impact::OutcomeSlopes& outcome,
                             const std::vector<UncertainInput>& inputs) {
  UncertainOutcome result{name_of(outcome), outcome.unit, outcome.value, 0.0};
  double variance = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto& slope = outcome.slope[i];
    if (!slope || !outcome.value) result.deviation.reset();
    const double part = slope ? *slope * inputs[i].deviation : 0;
    variance += part * part;
    result.share.push_back(part * part);
  }
  if (result.deviation) result.deviation = std::sqrt(variance);
  for (auto& share : result.share)
    share = result.deviation && variance > 0 ? std::optional(*share / variance) : std::nullopt;
  return result;
}

/// All inputs of a sample on one axis, normally distributed.
Design design_of(const std::vector<UncertainInput>& inputs, const Samples& samples) {
  Design design{.parameters = {}, .axes = {{.count = samples.count, .stride = 1}}};
  for (const auto& [key, place, value, deviation] : inputs)
    design.parameters.push_back(
        {.key = key,
         .place = place,
         .range = Range{
             .from = value - deviation, .to = value + deviation, .seed = samples.seed, .normal = true}});
  return design;
}

/// Mean and sum of squared differences from it, as values come in.
struct Spread {
  Index count = 0;
  double mean = 0, squares = 0;

  void add(double value) {
    const double from_mean = value - mean;
    mean += from_mean / static_cast<double>(++count);
    squares += from_mean * (value - mean);
  }
};

void sample(const scene::Document& document, Propagation& result) {
  const auto design = design_of(result.inputs, result.samples);
  Variation variation(document, design, find_slots(document, design));
  std::vector<Spread> spreads(result.outcomes.size());
  for (Index point = 0; point < result.samples.count; ++point) try {
      const auto outcome = outcomes(variation.at(point));
      if (outcome.ending != result.ending) {
        ++result.others;
        continue;
      }
      for (std::size_t i = 0; i < spreads.size(); ++i)
        if (outcome.outcome[i].value) spreads[i].add(*outcome.outcome[i].value);
    } catch (const scene::SceneError&) {
      ++result.others;
    }
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    if (spreads[i].count < 2) continue;
    result.outcomes[i].mean = spreads[i].mean;
    result.outcomes[i].sampled_deviation =
        std::sqrt(spreads[i].squares / static_cast<double>(spreads[i].count - 1));
  }
}

}  // namespace

Propagation propagate(const scene::Document& document, const scene::Scene& scene,
                      const std::vector<UncertainInput>& inputs, const Samples& samples) {
  std::vector<std::string> keys;
  for (const auto& input : inputs) keys.push_back(input.key);
  const auto slopes = sensitivity(document, scene, keys);
  Propagation result{
      .ending = slopes.ending, .inputs = inputs, .outcomes = {}, .samples = samples, .notes = slopes.notes};
  for (const auto& outcome : slopes.outcome) result.outcomes.push_back(first_order(outcome, inputs));
  if (samples.count > 0) sample(document, result);
  return result;
}

}  // namespace mariotte::study
