#include <cmath>

#include "mariotte/impact/impulses.hpp"
#include "mariotte/impact/sensitivity/contact_variation.hpp"
#include "mariotte/impact/sensitivity/law_parameters.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/impact/sensitivity/slope_run.hpp"
#include "mariotte/model/chain/chain_system.hpp"

namespace mariotte::impact {

using model::Chain;
using model::DimensionlessChain;

namespace {

std::string numbered(const char* name, std::size_t i) {
  return name + ("[" + std::to_string(i) + "]");
}

/// A parameter that is a number of the chain.
Parameter<Chain> element(const Chain& chain, std::vector<double> Chain::*list, const char* name,
                         std::size_t i, double step) {
  return {numbered(name, i), (chain.*list)[i], step, [chain, list, i](double value) {
            auto moved = chain;
            (moved.*list)[i] = value;
            return moved;
          }};
}

}  // namespace

std::vector<Parameter<Chain>> parameters(const Chain& chain) {
  std::vector<Parameter<Chain>> list;
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    if (std::isfinite(chain.mass[i]))
      list.push_back(element(chain, &Chain::mass, "mass", i, 0.01 * chain.mass[i]));
  for (std::size_t i = 0; i < chain.velocity.size(); ++i)
    list.push_back(element(chain, &Chain::velocity, "velocity", i, 1));
  for (std::size_t j = 0; j < chain.gap.size(); ++j) list.push_back(element(chain, &Chain::gap, "gap", j, 1));
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    for (auto& number : law_parameters(chain.law[j]))
      list.push_back({numbered("contact", j) + "." + number.key, number.value, number.step,
                      [chain, j, law = std::move(number.law)](double value) {
                        auto moved = chain;
                        moved.law[j] = law(value);
                        return moved;
                      }});
  if (chain.gravity != 0)
    list.push_back({"gravity", chain.gravity, std::abs(chain.gravity), [chain](double value) {
                      auto moved = chain;
                      moved.gravity = value;
                      return moved;
                    }});
  return list;
}

namespace {

std::vector<ShiftedModels<DimensionlessChain>> shifted(const DimensionlessChain& base,
                                                       const std::vector<Parameter<Chain>>& by) {
  std::vector<ShiftedModels<DimensionlessChain>> list;
  for (const auto& one : by) {
    auto& models = list.emplace_back();
    models.step = one.step;
    for (std::size_t k = 0; k < stencil.size(); ++k) {
      models.at[k] = base;
      restate(one.model(one.value + stencil[k].offset * one.step), models.at[k]);
    }
  }
  return list;
}

/// Slopes of the state at the start. The work of a contact that starts indented is its stored energy.
SlopeMatrix start_slopes(const std::vector<ShiftedModels<DimensionlessChain>>& shifted,
                         const model::ChainLayout& layout) {
  SlopeMatrix slopes(layout.size, std::ssize(shifted));
  std::array<std::vector<double>, stencil.size()> x;
  for (Index c = 0; c < slopes.columns; ++c) {
    for (std::size_t k = 0; k < stencil.size(); ++k) initial_state(shifted[c].at[k], layout, x[k]);
    for (Index r = 0; r < slopes.rows; ++r)
      slopes(r, c) = stencil_slope(shifted[c].step, [&](std::size_t k) { return x[k][r]; });
  }
  return slopes;
}

/// Slopes of `value(models[k], start, end)` where state and time move with the parameter.
struct EndSlopes {
  const SlopeMatrix& start;
  ConstState start_state;
  const SlopeRun<model::ChainSystem>& end;

  /// Impulses at the point k of the stencil, moved by `step` of parameter c.
  void impulses_at(const DimensionlessChain& moved, const model::ChainLayout& layout, Index c, double by,
                   std::vector<double>& p) const {
    std::vector<double> before(start_state.begin(), start_state.end()), after = end.run.state;
    for (Index r = 0; r < layout.size; ++r) {
      before[r] += by * start(r, c);
      after[r] += by * (end.slopes(r, c) + end.rate[r] * end.time[c]);
    }
    impulses(moved, layout, {before, after, end.run.time + by * end.time[c]}, p);
  }
};

}  // namespace

Sensitivity sensitivity(const Chain& chain, const std::vector<Parameter<Chain>>& by,
                        const hybrid::Options& asked) {
  model::validate(chain);
  hybrid::validate(asked);
  model::expect_end(chain, asked.max_time);
  auto options = asked;
  options.accuracy = std::max(1e-14, 0.01 * asked.accuracy);

  model::ChainSystem system;
  system.reset(chain, options.accuracy, std::isfinite(options.max_time));
  const auto& base = system.chain();
  const auto& layout = system.layout();
  const auto& scale = base.scale;
  std::vector<double> x0;
  initial_state(base, layout, x0);
  const auto models = shifted(base, by);
  ContactVariation<model::ChainTopology> variation(base, layout, models);
  const auto start = start_slopes(models, layout);
  SlopeLoop loop(system, variation, hybrid::scaled(options, scale));
  const auto end = loop.follow(x0, start);

  Sensitivity result;
  result.ending = end.run.ending;
  result.message = end.run.message;
  const Index columns = std::ssize(by);
  for (const auto& one : by) {
    result.parameter.push_back(one.name);
    result.parameter_value.push_back(one.value);
  }
  for (Index i = 0; i < layout.velocities(); ++i) {
    const Index place = layout.velocity[i];
    OutcomeSlopes velocity{
        .name = "velocity", .index = i, .value = end.run.state[place] * scale.velocity, .slope = {}};
    for (Index c = 0; c < columns; ++c)
      velocity.slope.push_back((end.slopes(place, c) + end.rate[place] * end.time[c]) * scale.velocity);
    result.outcome.push_back(std::move(velocity));
  }
  std::vector<double> p;
  std::vector<Index> periods;
  impulses(base, layout, {x0, end.run.state, end.run.time}, p);
  count_periods(end.run.changes, layout.contacts(), periods);
  clear_untouched(periods, p);
  SlopeMatrix by_parameter(layout.contacts(), columns);
  const EndSlopes ends{start, x0, end};
  for (Index c = 0; c < columns; ++c) {
    std::array<std::vector<double>, stencil.size()> moved;
    for (std::size_t k = 0; k < stencil.size(); ++k)
      ends.impulses_at(models[c].at[k], layout, c, stencil[k].offset * by[c].step, moved[k]);
    for (Index j = 0; j < layout.contacts(); ++j)
      if (periods[j] > 0)
        by_parameter(j, c) = stencil_slope(by[c].step, [&](std::size_t k) { return moved[k][j]; });
  }
  for (Index j = 0; j < layout.contacts(); ++j) {
    OutcomeSlopes impulse{.name = "impulse", .index = j, .value = p[j] * scale.momentum(), .slope = {}};
    for (Index c = 0; c < columns; ++c) impulse.slope.push_back(by_parameter(j, c) * scale.momentum());
    result.outcome.push_back(std::move(impulse));
  }
  for (Index j = 0; j + 1 < layout.contacts(); ++j) {
    const auto ratio = correlation_ratio(p, j);
    OutcomeSlopes icr{.name = "icr", .index = j, .value = ratio.value_or(NAN), .slope = {}};
    for (Index c = 0; c < columns; ++c) {
      if (ratio)
        icr.slope.push_back((by_parameter(j, c) - *ratio * by_parameter(j + 1, c)) / p[j + 1]);
      else
        icr.slope.push_back(std::nullopt);
    }
    result.outcome.push_back(std::move(icr));
  }
  OutcomeSlopes time{.name = "time", .index = {}, .value = end.run.time * scale.time, .slope = {}};
  for (Index c = 0; c < columns; ++c) time.slope.push_back(end.time[c] * scale.time);
  result.outcome.push_back(std::move(time));
  return result;
}

}  // namespace mariotte::impact
