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
/// Speeds above v_c, relative to it: the least, and each the double of the one before. Nearer ones are less
/// exact, and needed where the course of events changes next to v_c.
constexpr std::array least_distances{1e-4, 1e-5, 1e-6, 1e-7};
/// The square of the rebound vanishes at v_c but for that share of it at the least distance, unless its
/// course changes between.
constexpr double vanished = 1e-4;
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

/// What vanishes at v_c: the restitution of the tip, or the speed at which two bodies part.
struct Rebound {
  Slope value;
  std::vector<Slope> slope;
};

Rebound rebound(const impact::Sensitivity& of_run) {
  const auto& all = of_run.outcome;
  const auto restitution =
      std::find_if(all.begin(), all.end(), [](const auto& one) { return one.name == "e_n"; });
  if (restitution != all.end()) return {restitution->value, restitution->slope};
  const auto &left = all[0], &right = all[1];  // velocities
  Rebound parting{*right.value - *left.value, {}};
  for (std::size_t p = 0; p < of_run.parameter.size(); ++p) {
    const auto &of_left = left.slope[p], &of_right = right.slope[p];
    parting.slope.push_back(of_left && of_right ? Slope(*of_right - *of_left) : std::nullopt);
  }
  return parting;
}

/// −(∂e/∂p)/(∂e/∂v) by each parameter.
std::vector<Slope> quotients(std::vector<Slope> of_rebound) {
  const auto by_speed = of_rebound.back();
  of_rebound.pop_back();
  for (auto& one : of_rebound)
    if (one) one = by_speed ? Slope(*one == 0 ? 0 : -*one / *by_speed) : std::nullopt;
  return of_rebound;
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

/// Quotients at the speeds above v_c, what has to be said where one is missing, and whether the rebound has
/// one course from there down to v_c.
struct Near {
  std::array<std::vector<Slope>, speeds> quotient;
  std::vector<impact::SlopeNote> notes = {};
  bool is_even = false;
};

bool has_all(const std::vector<Slope>& slopes) {
  return std::all_of(slopes.begin(), slopes.end(), [](const Slope& one) { return one.has_value(); });
}

Near look(const Run& run, double capture_velocity, double least_distance) {
  Near near;
  std::array<Slope, speeds> square;
  for (std::size_t i = 0; i < speeds; ++i) {
    const auto of_run = run(capture_velocity * (1 + std::ldexp(least_distance, static_cast<int>(i))));
    auto found = rebound(of_run);
    if (near.notes.empty() && !has_all(found.slope)) near.notes = of_run.notes;
    square[i] = found.value ? Slope(*found.value * *found.value) : std::nullopt;
    near.quotient[i] = quotients(std::move(found.slope));
  }
  const auto left = limit(square).value;
  near.is_even = left && std::abs(*left) <= vanished * *square[0];
  return near;
}

/// As far from v_c as the rebound has one course.
Near look(const Run& run, double capture_velocity) {
  Near near;
  for (const double distance : least_distances)
    if (near = look(run, capture_velocity, distance); near.is_even) break;
  return near;
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
  const auto near = look(run, found->value());
  impact::Sensitivity result;
  result.in_doubt = !near.is_even;
  if (result.in_doubt)
    result.notes.push_back(
        {"contacts slip, stick or part in another order next to the capture velocity: slopes "
         "may be those of another order, and wrong"});
  result.ending = hybrid::Ending::separated;
  result.outcome.push_back({capture_velocity_name, {}, "m/s", found->value()});
  for (std::size_t p = 0; p < asked.size(); ++p)
    if (is_shown(asked[p].parameter, keys))
      add(limit({near.quotient[0][p], near.quotient[1][p], near.quotient[2][p], near.quotient[3][p]}),
          asked[p], result);
  if (!has_all(result.outcome[0].slope))
    for (auto note : near.notes) {
      if (note.error == 0) continue;  // it leaves out nothing
      note.text = "next to the capture velocity: " + note.text;
      result.notes.push_back(std::move(note));
    }
  return result;
}

}  // namespace mariotte::study
