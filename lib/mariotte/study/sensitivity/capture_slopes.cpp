#include "mariotte/study/sensitivity/capture_slopes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "mariotte/impact/sensitivity/stencil.hpp"
#include "mariotte/scene/key_path.hpp"
#include "mariotte/study/capture.hpp"
#include "mariotte/study/fault.hpp"
#include "mariotte/study/sensitivity/scene_numbers.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"

namespace mariotte::study {
namespace {

using Slope = std::optional<double>;

constexpr double accuracy = 1e-12, tolerance = 1e-14;
/// Speeds above v_c, relative to it: the least, and each the double of the one before.
constexpr double least_distance = 1e-4;
constexpr std::array powers{1.0, 1.5, 2.0};
constexpr std::size_t speeds = powers.size() + 1;
/// Quotients that the last power changes by more than that are not known so well.
constexpr double well_known = 1e-6;
/// What a number may move of v_c by rounding alone.
constexpr double speed_rounding = 1e-11;

using Keys = std::vector<std::string>;

/// A run at a speed. The last of its parameters is that speed; others like it have no effect.
using Run = std::function<impact::Sensitivity(double speed)>;

Run run_of(const scene::Document& document, const model::Chain& pair, const hybrid::Options& options,
           const Keys& keys, const impact::SlopeWatch& watch) {
  return [=](double speed) {
    auto by = chain_parameters(document, pair, keys);
    for (auto& one : by) {
      one.set = [set = one.set, speed](double to, model::Chain& moved) {
        set(to, moved);
        moved = struck(std::move(moved), speed);
      };
      one.is_linear = false;
    }
    by.push_back(
        {"speed", speed, 0.01 * speed, [pair](double to, model::Chain& moved) { moved = struck(pair, to); }});
    return impact::sensitivity(struck(pair, speed), by, options, watch);
  };
}

bool is_speed(const std::string& name) {
  return name == "normal_speed" || name == speed_key;
}

/// Dampings may depend on the speed: the scene is read again at each.
Run run_of(const scene::Document& document, const hybrid::Options& options, const Keys& keys,
           const impact::SlopeWatch& watch) {
  return [=](double speed) {
    auto at_speed = document;
    locate(at_speed.source, at_speed.tree, speed_key, {}).value = speed;
    const auto body = std::get<model::Microbody>(resolve(at_speed).model);
    auto by = body_parameters(at_speed, keys);
    for (auto& one : by)
      if (is_speed(one.name)) one.set = [body](double, model::Microbody& moved) { moved = body; };
    by.push_back(scene_parameter<model::Microbody>(at_speed, "speed", speed_key, {speed, speed}));
    return impact::sensitivity(body, by, options, watch);
  };
}

/// A parameter as the scene gives it, and how large a change of it counts as one: of zeros, too.
struct Asked {
  impact::ParameterValue parameter;
  double size;
};

/// What is asked for, and a run at any speed.
struct Strike {
  std::vector<Asked> asked;
  Run run;
};

Strike strike(const scene::Document& document, const Keys& keys, const impact::SlopeWatch& watch) {
  const auto scene = resolve(document);
  Strike result;
  const auto take = [&](const auto& list) {
    for (const auto& one : list)
      result.asked.push_back({{one.name, one.value}, one.step / impact::stencil_share});
  };
  const auto* body = std::get_if<model::Microbody>(&scene.model);
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  if (body && body->impacts == 1) {
    take(body_parameters(document, keys));
    result.run = run_of(document, scene.run, keys, watch);
  } else if (chain && chain->law.size() == 1) {
    take(chain_parameters(document, *chain, keys));
    result.run = run_of(document, *chain, scene.run, keys, watch);
  } else {
    throw scene::SceneError(document.source.name +
                                ": slopes of the capture velocity are those of a [body] "
                                "with one impact, or of two bodies of a [chain]",
                            fault::no_model);
  }
  return result;
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

/// −(∂e/∂p)/(∂e/∂v) by each parameter.
std::vector<Slope> quotients(const impact::Sensitivity& of_run) {
  auto list = rebound(of_run);
  const auto by_speed = list.back();
  list.pop_back();
  for (auto& one : list)
    if (one) one = by_speed ? Slope(*one == 0 ? 0 : -*one / *by_speed) : std::nullopt;
  return list;
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

/// Without keys, what has no effect is left out.
bool is_shown(const impact::ParameterValue& one, const Keys& keys) {
  const auto begins = [&](const char* name) { return one.name.starts_with(name); };
  return !keys.empty() || !(is_speed(one.name) || begins("velocity[") || begins("gap[") || begins("gravity"));
}

void add(const Limit& found, const Asked& by, impact::Sensitivity& result) {
  auto& outcome = result.outcome[0];
  auto slope = found.value;
  if (slope && std::abs(*slope * by.size) <= speed_rounding * *outcome.value) slope = 0;
  result.parameter.push_back(by.parameter);
  outcome.slope.push_back(slope);
  if (slope && *slope != 0 && found.change > well_known)
    result.notes.push_back(
        {fmt::format("the slope by {} is known to a share of {:.0e}", by.parameter.name, found.change)});
}

}  // namespace

impact::Sensitivity sensitivity_of_capture(const scene::Document& document, const Keys& keys,
                                           const impact::SlopeWatch& watch) {
  auto tight = document;
  locate(tight.source, tight.tree, "run.accuracy", {}).value =
      std::min(resolve(document).run.accuracy, accuracy);
  const auto [asked, run] = strike(tight, keys, watch);
  const auto found = capture_velocity(tight, tolerance, watch);
  if (!found) throw scene::SceneError(document.source.name + ": " + no_capture_velocity, fault::no_capture);
  std::array<std::vector<Slope>, speeds> near;
  for (std::size_t i = 0; i < speeds; ++i)
    near[i] = quotients(run(found->value() * (1 + std::ldexp(least_distance, static_cast<int>(i)))));
  impact::Sensitivity result;
  result.ending = hybrid::Ending::separated;
  result.outcome.push_back({capture_velocity_name, {}, "m/s", found->value()});
  for (std::size_t p = 0; p < asked.size(); ++p)
    if (is_shown(asked[p].parameter, keys))
      add(limit({near[0][p], near[1][p], near[2][p], near[3][p]}), asked[p], result);
  return result;
}

}  // namespace mariotte::study
