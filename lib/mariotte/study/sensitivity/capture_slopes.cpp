#include "mariotte/study/sensitivity/capture_slopes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/scene/key_path.hpp"
#include "mariotte/study/capture.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"

namespace mariotte::study {
namespace {

using Slope = std::optional<double>;

constexpr double accuracy = 1e-12, tolerance = 1e-14;
/// Speeds above v_c, relative to it: the least, and each the double of the one before.
constexpr double least_distance = 2e-5;
constexpr std::array powers{1.0, 1.5, 2.0};
constexpr std::size_t speeds = powers.size() + 1;
/// Quotients that the last power changes by more than that are not known so well.
constexpr double well_known = 1e-6;

/// A scene whose speed can be set.
struct Strike {
  scene::Document document;
  std::string parameter;  ///< by which slopes are those by the speed,
  double sign = 1;        ///< times this
  bool is_pair = false;
};

scene::Node& node(scene::Document& document, const std::string& key) {
  return locate(document.source, document.tree, key, {});
}

/// At the accuracy that small rebounds need.
Strike prepared(scene::Document document) {
  const auto scene = resolve(document);
  node(document, "run.accuracy").value = std::min(scene.run.accuracy, accuracy);
  const auto* body = std::get_if<model::Microbody>(&scene.model);
  if (body && body->impacts == 1) return {std::move(document), "normal_speed"};
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  if (!chain || chain->law.size() != 1)
    throw scene::SceneError(document.source.name +
                                ": slopes of the capture velocity are those of a [body] "
                                "with one impact, or of two bodies of a [chain]",
                            fault::no_model);
  const bool first = std::isfinite(chain->mass[0]);
  return {std::move(document), first ? "velocity[0]" : "velocity[1]", first ? 1.0 : -1.0, true};
}

void set_speed(Strike& strike, double speed) {
  if (!strike.is_pair) {
    node(strike.document, "incidence.normal_speed").value = speed;
    return;
  }
  const auto velocity = std::get<model::Chain>(resolve(strike.document).model).velocity;
  scene::Array both(2);
  both[0].value = strike.sign > 0 ? velocity[1] + speed : velocity[0];
  both[1].value = strike.sign > 0 ? velocity[1] : velocity[0] - speed;
  node(strike.document, "chain.velocity").value = std::move(both);
}

/// Of what vanishes at v_c: the restitution of the tip, or the speed at which two bodies part.
std::vector<Slope> rebound(const impact::Sensitivity& of_run) {
  const auto& all = of_run.outcome;
  const auto restitution =
      std::find_if(all.begin(), all.end(), [](const auto& one) { return one.name == "e_n"; });
  if (restitution != all.end()) return restitution->slope;
  std::vector<Slope> list;
  for (std::size_t p = 0; p < of_run.parameter.size(); ++p) {
    const auto &left = all[0].slope[p], &right = all[1].slope[p];  // of both velocities
    list.push_back(left && right ? Slope(*right - *left) : std::nullopt);
  }
  return list;
}

/// On nothing but the difference of both velocities the capture velocity of a pair depends, and not on that.
bool is_speed(const Strike& strike, const std::string& parameter) {
  return parameter == strike.parameter || (strike.is_pair && parameter.starts_with("velocity["));
}

/// Parameters but those of the speed, and −(∂e/∂p)/(∂e/∂v) by each.
struct Quotients {
  std::vector<impact::ParameterValue> parameter;
  std::vector<Slope> value;
};

Quotients quotients(const Strike& strike, const impact::Sensitivity& of_run) {
  const auto all = rebound(of_run);
  Slope by_speed;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (of_run.parameter[i].name == strike.parameter) by_speed = all[i];
  Quotients result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (is_speed(strike, of_run.parameter[i].name)) continue;
    result.parameter.push_back(of_run.parameter[i]);
    result.value.push_back(all[i] && by_speed ? Slope(-strike.sign * *all[i] / *by_speed) : std::nullopt);
  }
  return result;
}

/// At speeds whose distances from v_c double.
std::array<Quotients, speeds> quotients_near(Strike& strike, double captured,
                                             const std::vector<std::string>& keys,
                                             const impact::SlopeWatch& watch) {
  auto by = keys;
  if (!by.empty()) by.push_back(strike.parameter);
  std::array<Quotients, speeds> all;
  for (std::size_t i = 0; i < speeds; ++i) {
    set_speed(strike, captured * (1 + std::ldexp(least_distance, static_cast<int>(i))));
    all[i] = quotients(strike, sensitivity(strike.document, resolve(strike.document), by, {}, watch));
  }
  return all;
}

/// The limit of what is known at distances that double; empty if some value is missing.
struct Limit {
  Slope value;
  double change = 0;  ///< by the last power, relative
};

Limit limit(std::array<Slope, speeds> at) {
  if (!std::all_of(at.begin(), at.end(), [](const Slope& one) { return one.has_value(); })) return {};
  double before = 0;
  for (std::size_t k = 0; k < powers.size(); ++k) {
    const double factor = std::exp2(powers[k]);
    before = *at[0];
    for (std::size_t i = 0; i + k + 1 < speeds; ++i) at[i] = (factor * *at[i] - *at[i + 1]) / (factor - 1);
  }
  return {at[0], std::abs(*at[0] - before) / std::max(std::abs(*at[0]), 1e-300)};
}

void add(const Limit& found, const std::string& name, impact::Sensitivity& result) {
  result.outcome[0].slope.push_back(found.value);
  if (found.value && *found.value != 0 && found.change > well_known)
    result.notes.push_back(
        {fmt::format("the slope by {} is known to a share of {:.0e}", name, found.change)});
}

}  // namespace

impact::Sensitivity sensitivity_of_capture(const scene::Document& document,
                                           const std::vector<std::string>& keys,
                                           const impact::SlopeWatch& watch) {
  auto strike = prepared(document);
  const auto found = capture_velocity(strike.document, tolerance, watch);
  if (!found) throw scene::SceneError(document.source.name + ": " + no_capture_velocity, fault::no_capture);
  const auto near = quotients_near(strike, found->value(), keys, watch);
  impact::Sensitivity result;
  result.ending = hybrid::Ending::separated;
  result.parameter = near[0].parameter;
  result.outcome.push_back({capture_velocity_name, {}, "m/s", found->value()});
  for (std::size_t p = 0; p < result.parameter.size(); ++p) {
    std::array<Slope, speeds> of_one;
    for (std::size_t i = 0; i < speeds; ++i) of_one[i] = near[i].value[p];
    add(limit(of_one), result.parameter[p].name, result);
  }
  return result;
}

}  // namespace mariotte::study
