#include "mariotte/report/page/lead.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "mariotte/core/counted.hpp"
#include "mariotte/report/page/html_table.hpp"
#include "mariotte/report/page/html_text.hpp"

namespace mariotte::report {
namespace {

/// "Of 16.34 mJ of kinetic energy 99.5 % is left."
std::string energy(const Json& result) {
  const auto energy = result.value("energy", Json::object());
  if (!energy.contains("initial") || !energy.contains("final") || !energy["initial"].is_number()) return "";
  const double before = energy["initial"], after = energy["final"];
  if (!(before > 0) || energy.value("work", 0.0) != 0) return "";
  return fmt::format(" Of {} of energy {:.4g} % is kinetic energy in the end.", quantity(before, "J"),
                     100 * after / before);
}

/// Walls have a mass that is no number.
bool is_wall(const Json& result, std::size_t ball) {
  const auto mass = result.value("scene", Json::object()).value("mass", Json::array());
  return ball < mass.size() && mass[ball].is_null();
}

/// The fastest of the balls of a chain that are no walls.
std::string fastest(const Json& result) {
  if (result.value("model", "") != "chain") return "";
  const auto& velocity = result["final"]["velocity"];
  const auto speed = [&](std::size_t i) { return std::abs(velocity[i].get<double>()); };
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < velocity.size(); ++i)
    if (!is_wall(result, i) && (!most || speed(i) > speed(*most))) most = i;
  if (!most) return "";
  return fmt::format(" Ball {} is the fastest then, at {}.", *most + 1,
                     quantity(velocity[*most].get<double>(), "m/s"));
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
  const auto& varied = result["varied"];
  const auto is_varied = [&](const Json& key) {
    return std::any_of(varied.begin(), varied.end(), [&](const Json& one) { return one["key"] == key; });
  };
  for (const auto& one : result.value("columns", Json::array()))
    if (!is_varied(one["key"]) && one["least"].is_number())
      return fmt::format(" {} lies between {:.4g} and {:.4g}.", inline_text(one["key"]),
                         one["least"].get<double>(), one["greatest"].get<double>());
  return "";
}

std::string lead_of_sweep(const Json& result) {
  const auto failed = result.value("failed", Index{0});
  const auto points = result.value("points", Index{0});
  const auto* const all = points == 1 ? "It has a result." : "All have a result.";
  const auto results = failed == 0 ? all : fmt::format("{} without a result.", failed);
  return fmt::format("{} {} {}. {}{}", counted(points, "point"), points == 1 ? "varies" : "vary",
                     axes(result), results, outcome(result));
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

}  // namespace mariotte::report
