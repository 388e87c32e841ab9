#include "mariotte/study/sweep/slope_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "mariotte/core/nearest.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/study/sweep/columns.hpp"

namespace mariotte::study {
namespace {

constexpr std::string_view prefix = "sensitivity.";

template <class Model>
constexpr bool has_parameters = std::is_same_v<Model, model::Chain> || std::is_same_v<Model, model::Network>;

template <class Model>
std::vector<std::string> outcome_names(const Model& model) {
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

void expect_known(const std::string& key, const char* what, const std::string& name,
                  const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  const std::vector<std::string_view> names(known.begin(), known.end());
  throw ColumnError(
      fmt::format("'{}': this scene has no {} '{}'{}", key, what, name, suggestion(name, names)));
}

Dimension difference(const Dimension& a, const Dimension& b) {
  return {.kg = a.kg - b.kg, .m = a.m - b.m, .s = a.s - b.s};
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
  const auto dot = std::min(names.find('.'), names.size());
  return {column, std::string(names.substr(0, dot)),
          std::string(names.substr(std::min(dot + 1, names.size())))};
}

void expect_slope(const std::string& key, const scene::Scene& scene) {
  const auto wanted = slope_column(key, 0);
  std::visit(
      [&]<class Model>(const Model& model) {
        if constexpr (has_parameters<Model>) {
          expect_known(key, "outcome", wanted.outcome, outcome_names(model));
          std::vector<std::string> names;
          for (const auto& one : impact::parameters(model)) names.push_back(one.name);
          expect_known(key, "parameter", wanted.parameter, names);
        } else {
          throw ColumnError(fmt::format("'{}': slopes are columns of chains and networks alone", key));
        }
      },
      scene.model);
}

std::string unit_of_slope(const std::string& key, const scene::Scene& scene) {
  const auto wanted = slope_column(key, 0);
  std::string unit = "SI";
  std::visit(
      [&]<class Model>(const Model& model) {
        if constexpr (has_parameters<Model>) {
          const auto outcome = dimension_of(wanted.outcome, model);
          for (const auto& one : impact::parameters(model))
            if (one.name == wanted.parameter && one.dimension && outcome)
              unit = unit_of(difference(*outcome, *one.dimension));
        }
      },
      scene.model);
  return unit;
}

void fill_slopes(const scene::Scene& scene, const std::vector<SlopeColumn>& columns, std::span<double> out) {
  for (const auto& one : columns) out[one.column] = std::numeric_limits<double>::quiet_NaN();
  std::visit(
      [&]<class Model>(const Model& model) {
        if constexpr (has_parameters<Model>) {
          auto by = impact::parameters(model);
          std::erase_if(by, [&](const auto& parameter) {
            return std::none_of(columns.begin(), columns.end(),
                                [&](const auto& one) { return one.parameter == parameter.name; });
          });
          const auto slopes = impact::sensitivity(model, by, scene.run);
          for (const auto& one : columns)
            for (const auto& outcome : slopes.outcome)
              for (std::size_t c = 0; c < by.size(); ++c)
                if (by[c].name == one.parameter && name_of(outcome) == one.outcome && outcome.slope[c])
                  out[one.column] = *outcome.slope[c];
        }
      },
      scene.model);
}

}  // namespace mariotte::study
