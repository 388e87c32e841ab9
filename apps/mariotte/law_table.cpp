#include "law_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "command_line/exit_code.hpp"
#include "command_line/values.hpp"
#include "mariotte/scene/scene.hpp"
#include "mariotte/scene/text_file.hpp"

namespace mariotte::command {
namespace {

using Places = std::map<std::string, double>;  ///< by axis

/// Quotients of masses and velocities have so much rounding.
constexpr double rounding = 1e-12;

impact::IcrTable read_table(const std::string& path) {
  try {
    return impact::parse_icr_table(scene::read_text(path));
  } catch (const InvalidParameter& problem) {
    throw scene::SceneError(path + ": " + problem.what(), fault::no_icr_table);
  }
}

Places given_places(const std::vector<std::string>& at) {
  Places given;
  for (const auto& text : at) {
    const auto equals = text.find('=');
    if (equals == std::string::npos) throw UsageError("--at: write NAME=VALUE, not " + text);
    const auto name = text.substr(0, equals);
    const auto value = number(text.substr(equals + 1));
    if (!value) throw UsageError(fmt::format("--at {}: '{}' is no number", name, text.substr(equals + 1)));
    if (!given.emplace(name, *value).second) throw UsageError(fmt::format("--at: {} is given twice", name));
  }
  return given;
}

bool is_equal(double a, double b) {
  return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b));
}

/// Whether all from the second on are as it is.
bool rest_is_equal(const std::vector<double>& values) {
  return std::all_of(values.begin() + 1, values.end(), [&](double one) { return is_equal(one, values[1]); });
}

/// Of rows of equal balls, of which the first strikes.
Places places_of_row(const Balls& balls) {
  if (!is_equal(balls.mass[0], balls.mass[1]) || !rest_is_equal(balls.mass) || !rest_is_equal(balls.velocity))
    throw impact::OutsideTable("the table is of equal balls of which all but the first have one velocity");
  return {{"balls", static_cast<double>(balls.mass.size())}};
}

/// Of triplets, in the frame of the second ball.
Places places_of_triplet(const Balls& balls) {
  const auto& [m, v] = balls;
  return {{"mass-2", m[1] / m[0]}, {"mass-3", m[2] / m[0]}, {"v-3", (v[2] - v[1]) / (v[0] - v[1])}};
}

/// What the balls say of the axes of a table.
Places places_of(const Balls& balls, const impact::IcrTable& table) {
  if (balls.mass.size() < 2) return {};
  if (!(balls.velocity[0] > balls.velocity[1]))
    throw impact::OutsideTable("in the table the first ball strikes the second, which it does not do here");
  if (table.axis[0].name == "balls") return places_of_row(balls);
  return balls.mass.size() == 3 ? places_of_triplet(balls) : Places{};
}

/// The value of the table that differs by rounding alone, if there is one.
double rounded(double value, const impact::TableAxis& axis) {
  for (const double one : axis.values)
    if (is_equal(one, value)) return one;
  return value;
}

double place(const impact::TableAxis& axis, const Places& given, const Places& of_balls) {
  const auto said = given.find(axis.name), seen = of_balls.find(axis.name);
  if (seen == of_balls.end()) {
    if (said != given.end()) return said->second;
    if (axis.values.size() == 1) return axis.values[0];
    throw UsageError(
        fmt::format("give --at {}=VALUE: the table has {} values of it", axis.name, axis.values.size()),
        fault::law_incomplete);
  }
  if (said != given.end() && !is_equal(said->second, seen->second))
    throw impact::OutsideTable(fmt::format("--at {}={:g}: masses and velocities make it {:g}", axis.name,
                                           said->second, seen->second));
  return rounded(seen->second, axis);
}

}  // namespace

impact::TableAnswer look_up(const std::string& file, const std::vector<std::string>& at, const Balls& balls) {
  const auto table = read_table(file);
  auto given = given_places(at);
  const auto of_balls = places_of(balls, table);
  std::vector<double> places;
  for (const auto& axis : table.axis) {
    places.push_back(place(axis, given, of_balls));
    given.erase(axis.name);
  }
  if (!given.empty()) throw UsageError("--at: the table has no axis '" + given.begin()->first + "'");
  return look_up(table, places);
}

}  // namespace mariotte::command
