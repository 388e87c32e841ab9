#include "mariotte/impact/sensitivity/adjoint/adjoint.hpp"

#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/sensitivity/contact_sensitivity.hpp"
#include "mariotte/impact/sensitivity/law_parameters.hpp"
#include "mariotte/impact/watch/chain_run.hpp"
#include "mariotte/model/islands/islands.hpp"

namespace mariotte::impact {
namespace {

using model::Chain;
using model::DimensionlessChain;

/// A row as islands follow it, with its motion.
struct RecordedRun {
  DimensionlessChain chain;
  model::ChainLayout layout;
  MotionRecord motion;
  model::Islands::Run run;
};

void follow(const Chain& chain, hybrid::Options options, const SlopeWatch& watch, RecordedRun& recorded) {
  if (!options.flow) options.flow = flow::Kind::taylor;  // closed forms are no series
  auto& scaled = recorded.chain;
  make_dimensionless(chain, options.accuracy, scaled);
  const auto inner = tightened(options, chain.mass.size());
  fade_later(scaled, inner.accuracy);
  make_layout(scaled, recorded.layout);
  std::vector<double> start;
  initial_state(scaled, recorded.layout, start);
  model::Islands islands(scaled, recorded.layout, start, hybrid::scaled(inner, scaled.scale),
                         /*stay=*/std::isfinite(options.max_time), [&] {
                           return std::make_unique<MotionRecorder>(inner.accuracy, watch, recorded.motion);
                         });
  islands.run();
  recorded.run = std::move(islands.result());
}

/// In the units of the chain, per its units. Units of a stiffness depend on the exponent.
void restore_units(const DimensionlessChain& chain, RowSlopes& slopes) {
  const auto& unit = chain.scale;
  const double length = std::log(unit.length);
  for (double& one : slopes.mass) one *= unit.velocity / unit.mass;
  for (double& one : slopes.gap) one *= unit.velocity / unit.length;
  for (std::size_t j = 0; j < slopes.gap.size(); ++j) {
    const auto& law = *power_law(chain.law[j]);
    auto &by_stiffness = slopes.stiffness[j], &by_damping = slopes.damping[j];
    slopes.exponent[j] += length * (by_stiffness * law.stiffness + by_damping * law.damping);
    slopes.exponent[j] *= unit.velocity;
    const double power = std::pow(unit.length, law.exponent);
    by_stiffness *= unit.velocity * power / unit.force();
    by_damping *= unit.velocity * power / (unit.force() * unit.time);
  }
}

double slope_of(const RowSlopes& slopes, std::size_t j, const std::string& key) {
  return key == "stiffness" ? slopes.stiffness[j] : key == "damping" ? slopes.damping[j] : slopes.exponent[j];
}

/// Series have a clock in which such contacts begin and end smoothly.
bool has_clock(const contact::PowerLaw& law) {
  return law.exponent == 1 || law.exponent == 1.5;
}

/// The slope of the force by the indentation is unbounded where the contact begins.
bool begins_steeply(const contact::PowerLaw& law) {
  return law.damping > 0 && law.exponent > 1 && law.exponent < 2;
}

/// Σ of the numbers of a chain times their slopes.
double product(const RowSlopes& slopes, const Chain& chain) {
  double sum = 0;
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    if (!std::isinf(chain.mass[i])) sum += slopes.mass[i] * chain.mass[i];
    sum += slopes.velocity[i] * chain.velocity[i];
  }
  for (std::size_t j = 0; j < chain.law.size(); ++j) {
    const auto& law = *power_law(chain.law[j]);
    sum += slopes.gap[j] * chain.gap[j] + slopes.stiffness[j] * law.stiffness +
           slopes.damping[j] * law.damping + slopes.exponent[j] * law.exponent;
  }
  return sum;
}

std::string numbered(const char* name, std::size_t i) {
  return name + ("[" + std::to_string(i) + "]");
}

}  // namespace

const char* why_no_adjoint(const Chain& chain) {
  if (!chain.drive.empty()) return "slopes of what is driven are not computed";
  if (chain.gravity != 0) return "slopes of a row under gravity are not computed backwards";
  const auto any = [&](auto is) { return std::any_of(chain.law.begin(), chain.law.end(), is); };
  if (any([](const contact::Law& law) { return !power_law(law); }))
    return "slopes of laws that are no power laws are not computed backwards";
  const bool general = any([](const contact::Law& law) { return !has_clock(*power_law(law)); });
  if (general && any([](const contact::Law& law) { return begins_steeply(*power_law(law)); }))
    return "slopes of damped contacts with exponents between 1 and 2, other than 3/2 throughout, are not "
           "computed "
           "backwards";
  return nullptr;
}

Adjoint adjoint(const Chain& chain, std::span<const double> weights, const hybrid::Options& asked,
                const SlopeWatch& watch) {
  model::validate(chain);
  hybrid::validate(asked);
  model::expect_end(chain, asked.max_time);
  if (const char* why = why_no_adjoint(chain)) throw InvalidParameter(why);
  if (weights.size() != chain.mass.size()) throw InvalidParameter("there must be one weight per ball");
  RecordedRun recorded;
  follow(chain, for_slopes(asked), watch, recorded);
  const auto& [scaled, layout, motion, run] = recorded;
  Adjoint result{.ending = run.ending,
                 .message = run.message,
                 .slopes = {},
                 .pieces = std::ssize(motion.piece),
                 .bytes = motion.bytes()};
  for (std::size_t i = 0; i < weights.size(); ++i)
    result.value += weights[i] * run.state[layout.velocity[i]] * scaled.scale.velocity;
  result.slopes = sweep_back(scaled, motion, {run.time}, weights);
  restore_units(scaled, result.slopes);
  return result;
}

double slope_by(const RowSlopes& slopes, const Parameter<Chain>& by) {
  return stencil_slope(by.step, [&](std::size_t k) {
    return product(slopes, by.model(by.value + stencil[k].offset * by.step));
  });
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
    outcome.slope.push_back(slope);
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
  return result;
}

}  // namespace mariotte::impact
