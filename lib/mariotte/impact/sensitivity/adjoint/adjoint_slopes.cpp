#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"
#include "mariotte/impact/sensitivity/law_parameters.hpp"
#include "mariotte/impact/sensitivity/notes.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"

namespace mariotte::impact {

using model::Chain;

namespace {

double slope_of(const RowSlopes& slopes, std::size_t j, const std::string& key) {
  return key == "stiffness" ? slopes.stiffness[j] : key == "damping" ? slopes.damping[j] : slopes.exponent[j];
}

/// Σ of the slopes times what the numbers of a chain differ from those of another.
double change(const RowSlopes& slopes, const Chain& chain, const Chain& from) {
  double sum = 0;
  const auto add = [&](double slope, double value, double before) {
    if (value != before) sum += slope * (value - before);
  };
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    add(slopes.mass[i], chain.mass[i], from.mass[i]);
    add(slopes.velocity[i], chain.velocity[i], from.velocity[i]);
  }
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    const auto &law = *power_law(chain.law[j]), &before = *power_law(from.law[j]);
    add(slopes.gap[j], chain.gap[j], from.gap[j]);
    add(slopes.stiffness[j], law.stiffness, before.stiffness);
    add(slopes.damping[j], law.damping, before.damping);
    add(slopes.exponent[j], law.exponent, before.exponent);
  }
  return sum;
}

std::string numbered(const char* name, std::size_t i) {
  return name + ("[" + std::to_string(i) + "]");
}

}  // namespace

double slope_by(const RowSlopes& slopes, const Parameter<Chain>& by) {
  const auto base = by.model(by.value);
  return stencil_slope(by.step, [&](std::size_t k) {
    return change(slopes, by.model(by.value + stencil[k].offset * by.step), base);
  });
}

void note_waiting(Sensitivity& swept) {
  swept.notes.clear();
  auto missing = names_of(swept.parameter, [&](std::size_t c) { return !swept.outcome[0].slope[c]; });
  if (!missing.empty()) swept.notes.push_back(waiting_note(std::move(missing)));
}

Sensitivity as_sensitivity(const Chain& chain, const Adjoint& adjoint, const std::string& name,
                           std::optional<Index> index) {
  Sensitivity result{.ending = adjoint.ending,
                     .message = adjoint.message,
                     .parameter = {},
                     .outcome = {},
                     .notes = {},
                     .is_swept_back = true};
  auto& outcome = result.outcome.emplace_back(OutcomeSlopes{name, index, "m/s", adjoint.value, {}});
  const auto add = [&](std::string of, double value, double slope) {
    if (std::isinf(value)) return;
    result.parameter.push_back({std::move(of), value});
    outcome.slope.push_back(std::isnan(slope) ? std::nullopt : std::optional(slope));
  };
  const auto add_all = [&](const char* of, const std::vector<double>& values, const std::vector<double>& by) {
    for (std::size_t i = 0; i < values.size(); ++i) add(numbered(of, i), values[i], by[i]);
  };
  const auto& slopes = adjoint.slopes;
  add_all("mass", chain.mass, slopes.mass);
  add_all("velocity", chain.velocity, slopes.velocity);
  add_all("gap", chain.gap, slopes.gap);
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    for (const auto& number : law_parameters(chain.law[j]))
      add(numbered("contact", j) + "." + number.key, number.value, slope_of(slopes, j, number.key));
  note_waiting(result);
  return result;
}

}  // namespace mariotte::impact
