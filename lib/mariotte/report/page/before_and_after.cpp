#include "mariotte/report/page/before_and_after.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/page/html_table.hpp"
#include "mariotte/report/page/html_text.hpp"

namespace mariotte::report {
namespace {

constexpr const char* axis = "xyz";

Json part(const Json& list, std::size_t first, std::size_t step) {
  auto values = Json::array();
  for (std::size_t i = first; i < list.size(); i += step) values.push_back(list[i]);
  return values;
}

/// What JSON cannot say, by its name.
Json with_infinite(Json list, const char* name) {
  for (auto& one : list)
    if (one.is_null() || !std::isfinite(one.get<double>())) one = name;
  return list;
}

/// One line per ball, with as many columns of velocities as the balls have coordinates.
std::string balls(const Json& before, const Json& after, std::size_t dimension) {
  const auto& mass = before["mass"];
  std::vector<Column> columns = {{"mass", "kg", with_infinite(part(mass, 0, dimension), "wall")}};
  if (before.contains("radius")) columns.push_back({"radius", "m", with_infinite(before["radius"], "plane")});
  for (std::size_t k = 0; k < dimension; ++k) {
    const auto name = dimension > 1 ? fmt::format("velocity {} ", axis[k]) : "velocity ";
    columns.push_back({name + "before", "m/s", part(before["velocity"], k, dimension)});
    columns.push_back({name + "after", "m/s", part(after["velocity"], k, dimension)});
  }
  return table("ball", columns);
}

std::string freedoms(const Json& before, const Json& after) {
  return table("degree of freedom",
               {{"velocity before", "SI", before["velocity"]}, {"velocity after", "SI", after["velocity"]}});
}

/// A member of all objects of a list.
Json all_of(const Json& list, const char* name) {
  auto values = Json::array();
  for (const auto& one : list) values.push_back(one.value(name, Json(nullptr)));
  return values;
}

/// Of numbers or vectors; null where a number has no such component.
Json component(Json values, std::size_t k) {
  for (auto& one : values) one = one.is_array() ? one[k] : k == 0 ? one : Json(nullptr);
  return values;
}

/// One line per body with friction, with a column per component.
std::string bodies(const Json& before, const Json& after) {
  const auto& start = before["body"];
  const auto& end = after["bodies"];
  std::vector<Column> columns = {{"name", "", all_of(start, "name")}, {"mass", "kg", all_of(start, "mass")}};
  for (const auto& [name, unit] : {std::pair{"velocity", "m/s"}, std::pair{"spin", "rad/s"}}) {
    const auto count = start[0][name].is_array() ? start[0][name].size() : 1;
    for (std::size_t k = 0; k < count; ++k) {
      const auto title = count > 1 ? fmt::format("{} {} ", name, axis[k]) : fmt::format("{} ", name);
      columns.push_back({title + "before", unit, component(all_of(start, name), k)});
      columns.push_back({title + "after", unit, component(all_of(end, name), k)});
    }
  }
  return table("body", columns);
}

/// "1–2" or "floor–rod.1", what each contact joins; empty if it joins no balls.
Json pairs(const Json& contacts) {
  auto names = Json::array();
  for (const auto& one : contacts)
    for (const auto* key : {"balls", "between"})
      if (one.contains(key)) names.push_back(inline_text(one[key][0]) + "–" + inline_text(one[key][1]));
  return names.empty() ? Json(contacts.size(), nullptr) : names;
}

std::string contacts(const Json& scene) {
  const auto& list = scene["contact"];
  const auto each = [&](const char* name) { return all_of(list, name); };
  return "<h3>Contacts at the start</h3>\n" +
         table("contact", {{"between", "", pairs(list)},
                           {"law", "", each("law")},
                           {"stiffness k [N/mⁿ]", "", each("stiffness")},
                           {"damping [SI]", "", each("damping")},
                           {"exponent n", "", each("exponent")},
                           {"friction", "", each("tangential")},
                           {"coefficient μ", "", each("friction")},
                           {"gap", "m", scene.contains("gap") ? scene["gap"] : each("gap")}});
}

std::string body(const Json& before, const Json& after) {
  std::vector<Column> columns;
  for (const auto& [name, unit] : {std::pair{"velocity", "m/s"}, std::pair{"spin", "rad/s"}}) {
    columns.push_back({std::string(name) + " before", unit, before[name]});
    columns.push_back({std::string(name) + " after", unit, after[name]});
  }
  return table("along e", columns);
}

bool is_complete(const Json& result) {
  return result.contains("scene") && result.contains("final") &&
         (result["final"].contains("velocity") || result["final"].contains("bodies"));
}

/// "Of 16.34 mJ of kinetic energy 99.5 % is left."
std::string energy(const Json& result) {
  const auto energy = result.value("energy", Json::object());
  if (!energy.contains("initial") || !energy.contains("final") || !energy["initial"].is_number()) return "";
  const double before = energy["initial"], after = energy["final"];
  if (!(before > 0) || energy.value("work", 0.0) != 0) return "";
  return fmt::format(" Of {} of energy {:.4g} % is kinetic energy in the end.", quantity(before, "J"),
                     100 * after / before);
}

/// The fastest of the balls of a chain.
std::string fastest(const Json& result) {
  if (result.value("model", "") != "chain") return "";
  const auto& velocity = result["final"]["velocity"];
  const auto faster = [](const Json& a, const Json& b) {
    return std::abs(a.get<double>()) < std::abs(b.get<double>());
  };
  const auto most = std::max_element(velocity.begin(), velocity.end(), faster);
  if (most == velocity.end()) return "";
  return fmt::format(" Ball {} is the fastest then, at {}.", most - velocity.begin() + 1,
                     quantity(most->get<double>(), "m/s"));
}

/// What is varied along the axes: "chain.mass[0] and chain.gap[1]".
std::string axes(const Json& result) {
  std::vector<std::string> keys;
  for (const auto& one : result["varied"])
    if (one.contains("axis")) keys.push_back(inline_text(one["key"]));
  return fmt::format("{}", fmt::join(keys, " and "));
}

/// "icr[0] lies between 0.77 and 1.77" of the first column that is not varied.
std::string outcome(const Json& result) {
  const auto varied = all_of(result["varied"], "key");
  for (const auto& one : result.value("columns", Json::array()))
    if (std::find(varied.begin(), varied.end(), one["key"]) == varied.end() && one["least"].is_number())
      return fmt::format(" {} lies between {:.4g} and {:.4g}.", inline_text(one["key"]),
                         one["least"].get<double>(), one["greatest"].get<double>());
  return "";
}

std::string lead_of_sweep(const Json& result) {
  const auto failed = result.value("failed", Index{0});
  const auto results = failed == 0 ? "All have a result." : fmt::format("{} have no result.", failed);
  return fmt::format("{} points vary {}. {}{}", result.value("points", Index{0}), axes(result), results,
                     outcome(result));
}

std::string paragraph(const std::string& lead) {
  return "<p class=\"lead\">" + escaped(lead) + "</p>\n";
}

}  // namespace

std::string lead(const Json& result) {
  if (result.contains("varied")) return paragraph(lead_of_sweep(result));
  if (!result.contains("final") || !result["final"].contains("time") || !result.contains("events")) return "";
  const auto time = quantity(result["final"]["time"].get<double>(), "s");
  const bool is_over = result.value("ending", "") == "separated";
  const auto start = is_over ? "The last contact has opened after " + time + "."
                             : "The run ended (" + inline_text(result["ending"]) + ") after " + time + ".";
  return paragraph(start + fastest(result) + energy(result));
}

std::string before_and_after(const Json& result) {
  if (!is_complete(result)) return "";
  const auto& before = result["scene"];
  const auto& after = result["final"];
  const auto title = std::string("<h2>Before and after</h2>\n");
  if (result.value("model", "") == "microbody") return title + body(before["incidence"], after);
  if (after.contains("bodies")) return title + bodies(before, after) + contacts(before);
  const auto dimension = before.value("dimension", std::size_t{1});
  return title + (dimension > 0 ? balls(before, after, dimension) : freedoms(before, after)) +
         contacts(before);
}

}  // namespace mariotte::report
