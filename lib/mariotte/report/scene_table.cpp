#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/columns.hpp"
#include "mariotte/report/law_name.hpp"
#include "mariotte/report/table.hpp"

namespace mariotte::report {
namespace {

std::string number(double value) {
  return fmt::format("{:.10g}", value);
}

std::string heading(const scene::Scene& scene) {
  const Index walls = std::count_if(scene.chain.mass.begin(), scene.chain.mass.end(),
                                    [](double mass) { return std::isinf(mass); });
  std::string text = scene.title.empty() ? "Chain" : scene.title;
  text += fmt::format("\n{} balls", scene.chain.mass.size() - static_cast<std::size_t>(walls));
  if (walls > 0) text += fmt::format(" and {} wall{}", walls, walls > 1 ? "s" : "");
  if (scene.chain.gravity != 0) text += fmt::format(", gravity {} m/s²", number(scene.chain.gravity));
  if (scene.chain.precompressed) text += ", precompressed";
  return text + "\n";
}

std::string balls(const scene::Scene& scene) {
  const auto row = [&](Index i) -> Row {
    const auto k = static_cast<std::size_t>(i);
    const double mass = scene.chain.mass[k];
    Row cells = {fmt::format("{}", i + 1), std::isinf(mass) ? "wall" : number(mass),
                 number(scene.chain.velocity[k])};
    if (!scene.radius.empty())
      cells.push_back(std::isinf(scene.radius[k]) ? "plane" : number(scene.radius[k]));
    return cells;
  };
  Row header = {"ball", "mass [kg]", "velocity [m/s]"};
  if (!scene.radius.empty()) header.push_back("radius [m]");
  return columns(header, std::ssize(scene.chain.mass), row);
}

std::string contacts(const model::Chain& chain) {
  const auto row = [&](Index j) -> Row {
    const auto& law = chain.law[static_cast<std::size_t>(j)];
    return {fmt::format("{}", j + 1),        law_name(law),
            number(contact::stiffness(law)), number(contact::damping(law)),
            number(contact::exponent(law)),  number(chain.gap[static_cast<std::size_t>(j)])};
  };
  return columns({"contact", "law", "stiffness k [N/mⁿ]", "damping c [N s/mⁿ]", "exponent n", "gap [m]"},
                 std::ssize(chain.law), row);
}

std::string limits(const hybrid::Options& run) {
  const std::string time = std::isfinite(run.max_time) ? number(run.max_time) + " s" : "none";
  return fmt::format("\naccuracy {:.3g} · flow {} · time limit {} · event limit {}\n", run.accuracy, run.flow,
                     time, run.max_events);
}

}  // namespace

std::string table_of_body(const scene::Scene& scene);

std::string table(const scene::Scene& scene) {
  if (scene.body) return table_of_body(scene);
  return heading(scene) + "\n" + balls(scene) + "\n" + contacts(scene.chain) + limits(scene.run);
}

}  // namespace mariotte::report
