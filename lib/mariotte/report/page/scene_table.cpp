#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/core/overload.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/table/drive_table.hpp"
#include "mariotte/report/table/law_name.hpp"
#include "mariotte/report/table/network_table.hpp"
#include "mariotte/report/table/restitution_table.hpp"
#include "mariotte/report/table/table.hpp"
#include "mariotte/scene/restitution.hpp"

namespace mariotte::report {
namespace {

std::string number(double value) {
  return rounded(value, 10);
}

std::string heading(const model::Chain& chain, const scene::Scene& scene) {
  std::string text = scene.title.empty() ? "Chain" : scene.title;
  text += "\n" + size_of(chain);
  if (chain.gravity != 0) text += fmt::format(", gravity {} m/s²", number(chain.gravity));
  if (chain.precompressed) text += ", precompressed";
  if (!chain.drive.empty()) text += ", driven";
  return text + "\n";
}

std::string balls(const model::Chain& chain, const scene::Scene& scene) {
  const auto row = [&](Index i) -> TableRow {
    const auto k = static_cast<std::size_t>(i);
    const double mass = chain.mass[k];
    TableRow cells = {fmt::format("{}", i + 1), std::isinf(mass) ? "wall" : number(mass),
                      number(chain.velocity[k])};
    if (!scene.radius.empty())
      cells.push_back(std::isinf(scene.radius[k]) ? "plane" : number(scene.radius[k]));
    return cells;
  };
  TableRow header = {"ball", "mass [kg]", "velocity [m/s]"};
  if (!scene.radius.empty()) header.push_back("radius [m]");
  return columns(header, std::ssize(chain.mass), row);
}

TableRow contact_row(const std::string& name, const contact::Law& law, double gap) {
  const auto cells = law_cells(law, number);
  return {name, law_name(law), cells.stiffness, cells.damping, cells.exponent, number(gap), cells.others};
}

std::string contacts(const std::vector<contact::Law>& laws, const std::vector<double>& gaps,
                     const std::vector<std::string>& names) {
  TableRow header = {names.empty() ? "contact" : "contact (balls)",
                     "law",
                     "stiffness k [N/mⁿ]",
                     "damping c [N s/mⁿ]",
                     "exponent n",
                     "gap [m]",
                     "other numbers [SI]"};
  if (std::all_of(laws.begin(), laws.end(), [](const auto& law) { return power_law(law); }))
    header.pop_back();
  return columns(header, std::ssize(laws), [&](Index j) {
    const auto at = static_cast<std::size_t>(j);
    auto row =
        contact_row(names.empty() ? fmt::format("{}", j + 1) : fmt::format("{} ({})", j + 1, names[at]),
                    laws[at], gaps[at]);
    row.resize(header.size());
    return row;
  });
}

/// One line per dof.
std::string dofs(const model::Network& network) {
  const bool diagonal = model::is_diagonal(network.mass, std::ssize(network.velocity));
  const auto row = [&](Index i) -> TableRow {
    const auto k = static_cast<std::size_t>(i);
    return {fmt::format("{}", i + 1), number(network.mass[diagonal ? k : k * (network.velocity.size() + 1)]),
            number(network.velocity[k])};
  };
  const TableRow header = {"degree of freedom", diagonal ? "mass" : "mass (diagonal)", "velocity"};
  return columns(header, std::ssize(network.velocity), row);
}

/// One line per ball.
std::string placed_balls(const model::Network& network, const scene::Scene& scene) {
  const Index d = network.dimension;
  TableRow header = {"ball", "mass [kg]", "radius [m]"};
  for (Index k = 0; k < d; ++k) header.push_back(fmt::format("velocity {} [m/s]", "xyz"[k]));
  const auto row = [&](Index i) {
    TableRow cells = {fmt::format("{}", i + 1), number(network.mass[i * d]), number(scene.radius[i])};
    for (Index k = 0; k < d; ++k) cells.push_back(number(network.velocity[i * d + k]));
    return cells;
  };
  return columns(header, std::ssize(network.velocity) / d, row);
}

/// What pairs alone would do, where that is not simply elastic.
template <class Model>
std::string restitutions(const Model& model) {
  if (std::none_of(model.law.begin(), model.law.end(),
                   [](const auto& law) { return contact::dissipates(law); }))
    return "";
  return restitution_table(
      "contact", std::ssize(model.law), scene::largest_approach(model), [&](Index j, double speed) {
        return scene::restitution(model.law[j],
                                  {.reduced_mass = scene::reduced_mass(model, j), .speed = speed});
      });
}

std::string limits(const hybrid::Options& run) {
  const std::string time = std::isfinite(run.max_time) ? number(run.max_time) + " s" : "none";
  return fmt::format("\naccuracy {:.3g} · flow {} · time limit {} · event limit {}\n", run.accuracy,
                     flow::name(run.flow), time, run.max_events);
}

std::string table(const model::Chain& chain, const scene::Scene& scene) {
  return heading(chain, scene) + "\n" + balls(chain, scene) + "\n" + contacts(chain.law, chain.gap, {}) +
         drive_table(chain.drive, "ball", 1) + restitutions(chain) + limits(scene.run);
}

std::string table(const model::Network& network, const scene::Scene& scene) {
  const bool placed = network.dimension > 0;
  return (scene.title.empty() ? "Contact network" : scene.title) + "\n" + size_of(network) +
         (network.precompressed ? ", precompressed" : "") +
         (network.drive.empty() ? "\n\n" : ", driven\n\n") +
         (placed ? placed_balls(network, scene) : dofs(network)) + "\n" +
         contacts(network.law, network.gap, contact_names(network)) +
         drive_table(network.drive, placed ? "ball" : "degree of freedom", placed ? network.dimension : 1) +
         restitutions(network) + limits(scene.run);
}

}  // namespace

std::string table(const scene::Scene& scene) {
  return std::visit(Overload{[&](const model::Chain& chain) { return table(chain, scene); },
                             [&](const model::Network& network) { return table(network, scene); },
                             [&](const model::Microbody& body) { return table_of_body(body, scene); },
                             [&](const model::Bodies& bodies) { return table_of_bodies(bodies, scene); },
                             [](const scene::LawAlone& nothing) -> std::string { scene::refuse(nothing); }},
                    scene.model);
}

}  // namespace mariotte::report
