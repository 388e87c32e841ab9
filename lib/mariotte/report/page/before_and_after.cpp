#include "mariotte/report/page/before_and_after.hpp"

#include <fmt/format.h>

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

/// Of bodies, which may touch anywhere, the contacts of the result at these places.
Json acting(const Json& all, const Json& contacts, const std::vector<std::size_t>& places) {
  auto some = Json::array();
  for (const auto place : places)
    for (const auto& candidate : all)
      if (candidate.value("between", Json()) == contacts[place].value("between", Json()))
        some.push_back(candidate);
  return some;
}

std::string contacts(const Json& scene, const Json& list, const std::vector<std::size_t>& numbers = {}) {
  const auto each = [&](const char* name) { return all_of(list, name); };
  return "<h3>Contacts at the start</h3>\n" +
         table("contact",
               {{"between", "", pairs(list)},
                {"law", "", each("law")},
                {"stiffness k [N/mⁿ]", "", each("stiffness")},
                {"damping [SI]", "", each("damping")},
                {"exponent n", "", each("exponent")},
                {"separation", "", each("separation")},
                {"friction", "", each("tangential")},
                {"coefficient μ", "", each("friction")},
                {"gap", "m", scene.contains("gap") ? scene["gap"] : each("gap")}},
               numbers);
}

/// Of those that closed, with their numbers among all pairs.
std::string contacts_of_bodies(const Json& before, const Json& contacts_after) {
  auto places = closed_among(contacts_after);
  const auto list = acting(before["contact"], contacts_after, places);
  for (auto& one : places) ++one;
  return contacts(before, list, places);
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

}  // namespace

std::string before_and_after(const Json& result) {
  if (!is_complete(result)) return "";
  const auto& before = result["scene"];
  const auto& after = result["final"];
  const auto title = std::string("<h2>Before and after</h2>\n");
  if (result.value("model", "") == "microbody") return title + body(before["incidence"], after);
  if (after.contains("bodies"))
    return title + bodies(before, after) +
           contacts_of_bodies(before, result.value("contacts", Json::array()));
  const auto dimension = before.value("dimension", std::size_t{1});
  return title + (dimension > 0 ? balls(before, after, dimension) : freedoms(before, after)) +
         contacts(before, before["contact"]);
}

}  // namespace mariotte::report
