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

constexpr const char* speed_name = "normal_speed";
constexpr const char* speed_key = "incidence.normal_speed";
constexpr double accuracy = 1e-12, tolerance = 1e-14;
/// Speeds above v_c, relative to it: the least, and each the double of the one before.
constexpr double least_distance = 2e-5;
constexpr std::array powers{1.0, 1.5, 2.0};
constexpr std::size_t speeds = powers.size() + 1;
/// Quotients that the last power changes by more than that are not known so well.
constexpr double well_known = 1e-6;

void set(scene::Document& document, const std::string& key, double value) {
  locate(document.source, document.tree, key, {}).value = value;
}

/// Of one impact, at the accuracy that small rebounds need.
scene::Document prepared(scene::Document document) {
  const auto scene = resolve(document);
  const auto* body = std::get_if<model::Microbody>(&scene.model);
  if (!body || body->impacts != 1)
    throw scene::SceneError(
        document.source.name + ": slopes of the capture velocity are those of a [body] with one impact",
        fault::no_model);
  set(document, "run.accuracy", std::min(scene.run.accuracy, accuracy));
  return document;
}

/// −(∂e/∂p)/(∂e/∂v) by parameter; the parameter of the speed itself is left out.
std::vector<Slope> quotients(const impact::Sensitivity& of_run) {
  const auto restitution = std::find_if(of_run.outcome.begin(), of_run.outcome.end(),
                                        [](const auto& one) { return one.name == "e_n"; });
  std::vector<Slope> list, all = restitution->slope;
  Slope by_speed;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (of_run.parameter[i].name == speed_name) by_speed = all[i];
  for (std::size_t i = 0; i < all.size(); ++i)
    if (of_run.parameter[i].name != speed_name)
      list.push_back(all[i] && by_speed ? Slope(-*all[i] / *by_speed) : std::nullopt);
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
  auto moved = prepared(document);
  const auto found = capture_velocity(moved, tolerance, watch);
  if (!found) throw scene::SceneError(document.source.name + ": " + no_capture_velocity, fault::no_capture);
  auto by = keys;
  if (!by.empty()) by.push_back(speed_name);
  impact::Sensitivity result;
  result.ending = hybrid::Ending::separated;
  result.outcome.push_back({capture_velocity_name, {}, "m/s", found->value()});
  std::array<std::vector<Slope>, speeds> at;
  for (std::size_t i = 0; i < speeds; ++i) {
    set(moved, speed_key, found->value() * (1 + std::ldexp(least_distance, static_cast<int>(i))));
    const auto of_run = sensitivity(moved, resolve(moved), by, {}, watch);
    at[i] = quotients(of_run);
    result.parameter = of_run.parameter;
  }
  std::erase_if(result.parameter, [](const auto& one) { return one.name == speed_name; });
  for (std::size_t p = 0; p < result.parameter.size(); ++p) {
    std::array<Slope, speeds> of_one;
    for (std::size_t i = 0; i < speeds; ++i) of_one[i] = at[i][p];
    add(limit(of_one), result.parameter[p].name, result);
  }
  return result;
}

}  // namespace mariotte::study
