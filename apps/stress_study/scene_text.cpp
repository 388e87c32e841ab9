#include <fmt/format.h>

#include <sstream>

#include "law_numbers.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/report/number.hpp"
#include "scene.hpp"

namespace mariotte::stress_study {
namespace {

using report::exact;

std::string array(const std::vector<double>& values) {
  std::string all;
  for (const double value : values) all += (all.empty() ? "" : ", ") + exact(value);
  return "[" + all + "]";
}

/// The points of a curve, which a scene has in a file.
std::string point_table(const CubicCurve& curve) {
  std::string text = "table = \"points.csv\"\n# indentation [m], force [N]\n";
  for (const auto& segment : curve)
    text += fmt::format("# {}, {}\n", exact(segment.from), exact(segment.a[0]));
  return text;
}

std::string keys(const contact::Law& law) {
  if (const auto* curve = contact::curve(law)) return "law = \"tabulated\"\n" + point_table(*curve);
  const auto called = name(law);
  auto text = fmt::format("law = \"{}\"\n", called);
  const bool is_spring = called == "linear" || called == "hertz";
  for (const auto& [key, value] : contact::parameters(law))
    if (!is_spring || key == "stiffness") text += fmt::format("{} = {}\n", key, exact(value));
  return contact::is_uncut(law) ? text + "separation = \"indentation\"\n" : text;
}

std::string start(const std::vector<double>& gap, const std::vector<double>& velocity, bool precompressed) {
  return fmt::format("velocity = {}\n{}{}", array(velocity), "gap = " + array(gap) + "\n",
                     precompressed ? "precompressed = true\n" : "");
}

std::string tables(const model::Chain& chain) {
  auto text = fmt::format("[chain]\nmass = {}\n{}", array(chain.mass),
                          start(chain.gap, chain.velocity, chain.precompressed));
  if (chain.gravity != 0) text += "gravity = " + exact(chain.gravity) + "\n";
  for (const auto& law : chain.law) text += "[[chain.contact]]\n" + keys(law);
  return text;
}

std::string mass_of(const model::Network& network) {
  const auto n = network.velocity.size();
  if (network.mass.size() == n) return array(network.mass);
  std::string rows;
  for (std::size_t i = 0; i < n; ++i)
    rows += (i ? ", " : "") + array({network.mass.begin() + static_cast<Index>(n * i),
                                     network.mass.begin() + static_cast<Index>(n * (i + 1))});
  return "[" + rows + "]";
}

std::string tables(const model::Network& network) {
  auto text = fmt::format("[network]\nmass = {}\n{}", mass_of(network),
                          start(network.gap, network.velocity, network.precompressed));
  for (std::size_t j = 0; j < network.law.size(); ++j) {
    std::vector<double> row(network.velocity.size());
    for (const auto& [i, coefficient] : network.direction[j]) row[static_cast<std::size_t>(i)] = coefficient;
    text += "[[network.contact]]\ndirection = " + array(row) + "\n" + keys(network.law[j]);
  }
  return text;
}

}  // namespace

std::string text(const Scene& scene, double accuracy, const std::string& notes) {
  std::string all, line;
  for (std::istringstream lines(notes); std::getline(lines, line);) all += "# " + line + "\n";
  auto run = "[run]\naccuracy = " + exact(accuracy) + "\n";
  if (scene.max_time < infinity) run += "max_time = " + exact(scene.max_time) + "\n";
  return all + std::visit(Overload{[&](const model::Chain& chain) { return run + tables(chain); },
                                   [&](const model::Network& network) { return run + tables(network); },
                                   [](const auto& read) { return read.text; }},
                          scene.model);
}

}  // namespace mariotte::stress_study
