#include "mariotte/study/sweep/slope_columns.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "mariotte/core/nearest.hpp"
#include "mariotte/study/sensitivity/scene_numbers.hpp"
#include "mariotte/study/sensitivity/scene_parameters.hpp"
#include "mariotte/study/sweep/columns.hpp"

namespace mariotte::study {
namespace {

constexpr std::string_view prefix = "sensitivity.";

template <class Model>
constexpr bool has_balls = std::is_same_v<Model, model::Chain> || std::is_same_v<Model, model::Network>;

template <class Model>
std::vector<std::string> names_of_balls(const Model& model) {
  std::vector<std::string> names{"time"};
  const auto add = [&](const char* name, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) names.push_back(fmt::format("{}[{}]", name, i));
  };
  add("velocity", model.velocity.size());
  add("impulse", model.law.size());
  add("icr", model.law.empty() ? 0 : model.law.size() - 1);
  const auto dissipates = [](const contact::Law& law) { return contact::dissipates(law); };
  if (std::any_of(model.law.begin(), model.law.end(), dissipates)) names.push_back("dissipated");
  return names;
}

/// Empty where only a run would tell.
std::vector<std::string> outcome_names(const scene::Scene& scene, bool may_run) {
  return std::visit(
      [&]<class Model>(const Model& model) {
        std::vector<std::string> names;
        if constexpr (has_balls<Model>)
          names = names_of_balls(model);
        else if (may_run)
          for (const auto& one : outcomes(scene).outcome) names.push_back(name_of(one));
        return names;
      },
      scene.model);
}

void expect_known(const std::string& key, const char* what, const std::string& name,
                  const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  const std::vector<std::string_view> names(known.begin(), known.end());
  throw ColumnError(
      fmt::format("'{}': this scene has no {} '{}'{}", key, what, name, suggestion(name, names)));
}

std::optional<SceneNumber> find_number(const scene::Document& document, const std::string& key) try {
  return number_at(document, key);
} catch (const scene::SceneError&) {
  return {};
}

/// Of a slope: no angle is meant by s⁻¹.
std::string quotient(const Dimension& a, const Dimension& b) {
  const auto unit = unit_of({.kg = a.kg - b.kg, .m = a.m - b.m, .s = a.s - b.s});
  return unit == "rad/s" ? "s^-1" : unit;
}

/// Of "velocity[2]".
template <class Model>
std::optional<Dimension> dimension_of(const std::string& outcome, const Model& model) {
  if (outcome == "time") return dimension::time;
  if (outcome == "dissipated") return dimension::energy;
  if (outcome.starts_with("icr")) return dimension::none;
  if (outcome.starts_with("impulse")) return dimension::damping(0);
  if constexpr (std::is_same_v<Model, model::Network>)
    if (model.dimension == 0) return {};
  return dimension::velocity;
}

}  // namespace

bool is_slope(std::string_view key) {
  return key.starts_with(prefix);
}

SlopeColumn slope_column(std::string_view key, std::size_t column) {
  const auto names = key.substr(prefix.size());
  auto dot = names.find('.');
  if (names.starts_with("bodies[") && dot != names.npos) dot = names.find('.', dot + 1);
  dot = std::min(dot, names.size());
  return {column, std::string(names.substr(0, dot)),
          std::string(names.substr(std::min(dot + 1, names.size())))};
}

void expect_slope(const std::string& key, const WrittenScene& example, bool may_run) {
  const auto wanted = slope_column(key, 0);
  if (const auto names = outcome_names(example.scene, may_run); !names.empty())
    expect_known(key, "outcome", wanted.outcome, names);
  const auto names = number_names(example.document, example.scene);
  if (!find_number(example.document, wanted.number)) expect_known(key, "number", wanted.number, names);
}

std::string unit_of_slope(const std::string& key, const WrittenScene& example) {
  const auto wanted = slope_column(key, 0);
  const auto of_scene = find_number(example.document, wanted.number);
  return std::visit(
      [&]<class Model>(const Model& model) -> std::string {
        if constexpr (has_balls<Model>) {
          const auto outcome = dimension_of(wanted.outcome, model);
          if (of_scene && outcome) return quotient(*outcome, of_scene->dimension);
          for (const auto& one : impact::parameters(model))
            if (one.name == wanted.number && one.dimension && outcome)
              return quotient(*outcome, *one.dimension);
        }
        return "SI";
      },
      example.scene.model);
}

std::string fill_slopes(const WrittenScene& point, const std::vector<SlopeColumn>& columns,
                        std::span<double> out) {
  std::vector<std::string> numbers;
  for (const auto& one : columns) {
    out[one.column] = std::numeric_limits<double>::quiet_NaN();
    if (std::find(numbers.begin(), numbers.end(), one.number) == numbers.end()) numbers.push_back(one.number);
  }
  auto slopes = sensitivity(point.document, point.scene, numbers);
  for (const auto& one : columns)
    for (const auto& outcome : slopes.outcome)
      for (std::size_t c = 0; c < slopes.parameter.size(); ++c)
        if (slopes.parameter[c].name == one.number && name_of(outcome) == one.outcome && outcome.slope[c])
          out[one.column] = *outcome.slope[c];
  std::erase_if(slopes.notes, [&](const impact::SlopeNote& note) {
    return std::none_of(columns.begin(), columns.end(),
                        [&](const auto& one) { return concerns(note, one.outcome, one.number); });
  });
  return fmt::format("{}", fmt::join(texts(slopes.notes), "; "));
}

}  // namespace mariotte::study
