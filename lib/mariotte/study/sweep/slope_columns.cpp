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
  const auto problem =
      fmt::format("'{}': this scene has no {} '{}'{}", key, what, name, suggestion(name, names));
  const auto open = name.find('[');  // another point may have more of them
  const auto is_like = [&](const std::string& one) { return one.starts_with(name.substr(0, open + 1)); };
  if (open != name.npos && std::any_of(known.begin(), known.end(), is_like)) throw BeyondEnd(problem);
  throw ColumnError(problem);
}

/// Where "velocity[2]", "bodies[0].spin" or "contacts[0].losses.friction" ends.
std::size_t end_of_outcome(std::string_view names) {
  auto end = names.find('.');
  const auto next = [&] { end = end == names.npos ? end : names.find('.', end + 1); };
  const bool is_of_contact = names.starts_with("contacts[");
  if (is_of_contact || names.starts_with("bodies[")) {
    const bool has_kind = is_of_contact && end != names.npos && names.substr(end).starts_with(".losses.");
    next();
    if (has_kind) next();
  }
  return std::min(end, names.size());
}

std::vector<std::string> find_elements(const scene::Document& document, const std::string& key) try {
  return elements_of(document, key);
} catch (const scene::SceneError&) {
  return {};
}

std::optional<SceneNumber> find_number(const scene::Document& document, const std::string& key) try {
  return number_at(document, key);
} catch (const scene::SceneError&) {
  return {};
}

constexpr std::string_view every = "[*]";

/// "mass[2]" is like "mass[*]".
bool is_like(std::string_view name, std::string_view pattern) {
  const auto star = pattern.find(every);
  if (star == pattern.npos) return name == pattern;
  const auto end = name.find(']');
  return name.substr(0, star + 1) == pattern.substr(0, star + 1) && end != name.npos &&
         is_like(name.substr(end + 1), pattern.substr(star + every.size()));
}

/// The name itself unless it stands for several.
std::vector<std::string> all_like(const std::string& name, std::vector<std::string> known) {
  if (name.find(every) == name.npos) return {name};
  std::erase_if(known, [&](const std::string& one) { return !is_like(one, name); });
  return known;
}

/// Of a list of the scene its elements, else those of the model.
std::vector<std::string> numbers_like(const std::string& name, const WrittenScene& example) {
  if (name.ends_with(every)) {
    const auto list = name.substr(0, name.size() - every.size());
    if (auto all = find_elements(example.document, list); !all.empty() && all[0] != list) return all;
  }
  return all_like(name, number_names(example.document, example.scene));
}

/// Of a slope: no angle is meant by s⁻¹.
std::string quotient(const Dimension& a, const Dimension& b) {
  const auto unit = unit_of(Dimension{.kg = a.kg - b.kg, .m = a.m - b.m, .s = a.s - b.s});
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

void take(const impact::Sensitivity& slopes, const std::vector<SlopeColumn>& columns, std::span<double> out) {
  for (const auto& one : columns)
    for (const auto& outcome : slopes.outcome)
      for (std::size_t c = 0; c < slopes.parameter.size(); ++c)
        if (slopes.parameter[c].name == one.number && name_of(outcome) == one.outcome && outcome.slope[c])
          out[one.column] = *outcome.slope[c];
}

/// What notes say of columns.
std::vector<std::string> said(std::vector<impact::SlopeNote> notes, const std::vector<SlopeColumn>& columns) {
  std::erase_if(notes, [&](const impact::SlopeNote& note) {
    return std::none_of(columns.begin(), columns.end(),
                        [&](const auto& one) { return concerns(note, one.outcome, one.number); });
  });
  return texts(notes);
}

}  // namespace

bool is_slope(std::string_view key) {
  return key.starts_with(prefix);
}

SlopeColumn slope_column(std::string_view key, std::size_t column) {
  const auto names = key.substr(prefix.size());
  const auto dot = end_of_outcome(names);
  return {column, std::string(names.substr(0, dot)),
          std::string(names.substr(std::min(dot + 1, names.size())))};
}

std::vector<std::string> each_slope(const std::string& key, const WrittenScene& example, bool may_run) {
  if (key.find(every) == key.npos) return {key};
  const auto wanted = slope_column(key, 0);
  std::vector<std::string> all;
  for (const auto& outcome : all_like(wanted.outcome, outcome_names(example.scene, may_run)))
    for (const auto& number : numbers_like(wanted.number, example))
      all.push_back(fmt::format("{}{}.{}", prefix, outcome, number));
  return all.empty() ? std::vector{key} : all;  // which is refused
}

void expect_slope(const std::string& key, const WrittenScene& example, bool may_run) {
  const auto wanted = slope_column(key, 0);
  if (const auto names = outcome_names(example.scene, may_run); !names.empty())
    expect_known(key, "outcome", wanted.outcome, names);
  if (find_number(example.document, wanted.number)) return;
  if (const auto elements = find_elements(example.document, wanted.number); elements.size() > 1)
    throw ColumnError(
        fmt::format("'{}': '{}' is a list: say which, as '{}'", key, wanted.number, elements[0]));
  expect_known(key, "number", wanted.number, number_names(example.document, example.scene));
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
  std::vector<std::string> numbers, notes;
  for (const auto& one : columns) {
    out[one.column] = std::numeric_limits<double>::quiet_NaN();
    if (std::find(numbers.begin(), numbers.end(), one.number) == numbers.end()) numbers.push_back(one.number);
  }
  const auto fill = [&](const std::vector<std::string>& by) {
    const auto slopes = sensitivity(point.document, point.scene, by);
    take(slopes, columns, out);
    for (auto& text : said(slopes.notes, columns)) notes.push_back(std::move(text));
  };
  try {
    fill(numbers);
  } catch (const scene::SceneError&) {  // a number of them has no slopes: the others have
    for (const auto& number : numbers) try {
        fill({number});
      } catch (const scene::SceneError& error) {
        notes.emplace_back(error.what());
      }
  }
  return fmt::format("{}", fmt::join(notes, "; "));
}

}  // namespace mariotte::study
