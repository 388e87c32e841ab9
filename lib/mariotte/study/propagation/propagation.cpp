#include "mariotte/study/propagation/propagation.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unordered_map>

#include "mariotte/scene/key_path.hpp"
#include "mariotte/study/capture.hpp"
#include "mariotte/study/propagation/outcome_columns.hpp"
#include "mariotte/study/sensitivity/capture_slopes.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"
#include "mariotte/study/sweep/evaluate.hpp"
#include "mariotte/study/sweep/variation.hpp"

namespace mariotte::study {
namespace {

bool is_rounding(double slope, const UncertainInput& input, const std::optional<double>& outcome) {
  return outcome && impact::is_rounding(slope, std::max(std::abs(input.value), input.deviation), *outcome);
}

UncertainOutcome first_order(const impact::OutcomeSlopes& outcome,
                             const std::vector<UncertainInput>& inputs) {
  UncertainOutcome result{name_of(outcome), outcome.unit, outcome.value, 0.0};
  double variance = 0;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto& slope = outcome.slope[i];
    if (!slope || !outcome.value) result.deviation.reset();
    const double part =
        slope && !is_rounding(*slope, inputs[i], outcome.value) ? *slope * inputs[i].deviation : 0;
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

/// The same of all outcomes, of the samples that end as the scene does.
class Spreads {
 public:
  explicit Spreads(Propagation& result) : result_(result), spreads_(result.outcomes.size()) {}

  void add(bool ends_so, const auto& value_of) {
    if (!ends_so) return leave_out();
    for (std::size_t i = 0; i < spreads_.size(); ++i)
      if (const std::optional<double> value = value_of(i)) spreads_[i].add(*value);
  }
  void leave_out() { ++result_.others; }
  void report() const {
    for (std::size_t i = 0; i < spreads_.size(); ++i) {
      if (spreads_[i].count < 2) continue;
      result_.outcomes[i].mean = spreads_[i].mean;
      result_.outcomes[i].sampled_deviation =
          std::sqrt(spreads_[i].squares / static_cast<double>(spreads_[i].count - 1));
    }
  }

 private:
  Propagation& result_;
  std::vector<Spread> spreads_;
};

/// Which pairs may touch depends on the reach of a network's balls, and on the places of bodies.
std::size_t contacts(const scene::Scene& scene) {
  const auto* network = std::get_if<model::Network>(&scene.model);
  const auto* bodies = std::get_if<model::Bodies>(&scene.model);
  return network ? network->law.size() : bodies ? bodies->contact.size() : 0;
}

void for_each_sample(const scene::Document& document, const Propagation& result, Spreads& spreads,
                     const std::function<void(const scene::Scene&)>& run) {
  const auto design = design_of(result.inputs, result.samples);
  Variation variation(document, design, find_slots(document, design));
  const auto usual = contacts(resolve(document));
  for (Index point = 0; point < result.samples.count; ++point) try {
      const auto& scene = variation.at(point);
      contacts(scene) == usual ? run(scene) : spreads.leave_out();
    } catch (const scene::SceneError&) {
      spreads.leave_out();
    } catch (const InvalidParameter&) {
      spreads.leave_out();
    }
}

void sample_side_by_side(const scene::Document& document, const std::vector<Column>& columns,
                         Propagation& result, Spreads& spreads) {
  Evaluations evaluations(columns, [&](Index, const Verdict& verdict, std::span<const double> numbers) {
    spreads.add(verdict.ending == name(result.ending), [&](std::size_t i) {
      return std::isfinite(numbers[i]) ? std::optional(numbers[i]) : std::nullopt;
    });
  });
  for_each_sample(document, result, spreads, [&](const auto& scene) { evaluations.put(0, scene); });
  evaluations.finish();
}

/// Values by name, since a sample has no outcomes of a contact that does not act in it, nor of a loss that it
/// has not: both are zero.
class ValuesByName {
 public:
  explicit ValuesByName(const impact::Sensitivity& found) {
    for (const auto& one : found.outcome) values_.emplace(name_of(one), one.value);
  }
  std::optional<double> operator()(const std::string& name) const {
    const auto found = values_.find(name);
    if (found != values_.end()) return found->second;
    return name.starts_with("contacts[") ? std::optional(0.0) : std::nullopt;
  }

 private:
  std::unordered_map<std::string, std::optional<double>> values_;
};

void sample_one_by_one(const scene::Document& document, Propagation& result, Spreads& spreads) {
  for_each_sample(document, result, spreads, [&](const auto& scene) {
    const auto found = outcomes(scene);
    const ValuesByName values(found);
    spreads.add(found.ending == result.ending,
                [&](std::size_t i) { return values(result.outcomes[i].name); });
  });
}

/// A search per sample, with the numbers of that.
void sample_captures(scene::Document document, Propagation& result, Spreads& spreads) {
  constexpr double tolerance = 1e-9;
  const auto design = design_of(result.inputs, result.samples);
  for (Index point = 0; point < result.samples.count; ++point) try {
      for (std::size_t i = 0; i < result.inputs.size(); ++i)
        locate(document.source, document.tree, result.inputs[i].key, {}).value = number(design, i, point);
      const auto found = capture_velocity(document, tolerance);
      spreads.add(found.has_value(), [&](std::size_t) { return found->value(); });
    } catch (const Error&) {  // of a scene, or of a run on the way
      spreads.leave_out();
    }
}

void sample(const scene::Document& document, const std::vector<impact::OutcomeSlopes>& outcomes,
            Propagation& result) {
  Spreads spreads(result);
  if (outcomes.size() == 1 && outcomes[0].name == capture_velocity_name)
    sample_captures(document, result, spreads);
  else if (const auto columns = columns_of(outcomes))
    sample_side_by_side(document, *columns, result, spreads);
  else
    sample_one_by_one(document, result, spreads);
  spreads.report();
}

}  // namespace

Propagation propagate(const scene::Document& document, const scene::Scene& scene,
                      const std::vector<UncertainInput>& inputs, const Samples& samples,
                      const std::vector<std::string>& of) {
  std::vector<std::string> keys;
  for (const auto& input : inputs) keys.push_back(input.key);
  auto slopes = sensitivity(document, scene, keys, of);
  keep_asked_for(slopes.outcome, of);
  Propagation result{.ending = slopes.ending,
                     .message = slopes.message,
                     .inputs = inputs,
                     .outcomes = {},
                     .samples = samples,
                     .notes = texts(slopes.notes)};
  for (const auto& outcome : slopes.outcome) result.outcomes.push_back(first_order(outcome, inputs));
  if (samples.count > 0) sample(document, slopes.outcome, result);
  return result;
}

}  // namespace mariotte::study
