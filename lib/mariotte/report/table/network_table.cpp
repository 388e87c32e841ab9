#include "mariotte/report/table/network_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "mariotte/core/counted.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr std::array axis = {"x", "y", "z"};

std::string ball_motion(const model::Network& network, const std::vector<double>& after) {
  auto all = network.velocity;
  all.insert(all.end(), after.begin(), after.end());
  const auto velocity = display_for(all, "m/s");
  TableRow header = {"ball"};
  for (const char* when : {"before", "after"})
    for (Index k = 0; k < network.dimension; ++k)
      header.push_back(fmt::format("{} {} [{}]", axis[k], when, velocity.unit));
  const auto row = [&](Index i) {
    TableRow cells = {fmt::format("{}", i + 1)};
    for (const auto* values : {&network.velocity, &after})
      for (Index k = 0; k < network.dimension; ++k)
        cells.push_back(shown(velocity, (*values)[i * network.dimension + k]));
    return cells;
  };
  return "\nVelocities\n" + columns(header, std::ssize(after) / network.dimension, row);
}

}  // namespace

std::string size_of(const model::Network& network) {
  const auto dofs = std::ssize(network.velocity);
  const auto things = network.dimension == 0 ? counted(dofs, "degree of freedom", "degrees of freedom")
                                             : counted(dofs / network.dimension, "ball") +
                                                   (network.dimension == 2 ? " in the plane" : " in space");
  return things + ", " + counted(network.law.size(), "contact");
}

std::string motion_table(const model::Network& network, const std::vector<double>& after) {
  if (network.dimension > 0) return ball_motion(network, after);
  auto all = network.velocity;
  all.insert(all.end(), after.begin(), after.end());
  const auto velocity = display_for(all, "");
  const auto row = [&](Index i) -> TableRow {
    return {fmt::format("{}", i + 1), shown(velocity, network.velocity[i]), shown(velocity, after[i])};
  };
  return "\nVelocities\n" +
         columns({"degree of freedom", "before [SI]", "after [SI]"}, std::ssize(after), row);
}

std::vector<std::string> contact_names(const model::Network& network) {
  std::vector<std::string> names;
  for (Index j = 0; j < std::ssize(network.law); ++j)
    if (const auto pair = balls_of(network, j))
      names.push_back(fmt::format("{}–{}", pair->left + 1, pair->right + 1));
  return names;
}

std::string direction_table(const impact::ContactImpact& impact) {
  const auto& r = impact.impulse_direction;
  if (std::all_of(r.begin(), r.end(), [](double one) { return one == 0; })) return "";
  const auto row = [&](Index j) -> TableRow { return {fmt::format("{}", j + 1), fixed(r[j], 10)}; };
  return "\nImpulse direction\n" + columns({"contact", "r"}, std::ssize(r), row);
}

std::string neglected_table(const impact::NetworkImpact& impact) {
  if (!impact.turning) return "";
  const double turning = *impact.turning;
  const auto text =
      fmt::format("\nNeglected\n  turning of contact directions: up to {:.3g}° while contacts were closed\n",
                  turning * 180 / std::numbers::pi);
  if (turning <= impact.requested_accuracy) return text;
  return text + fmt::format("  It changes velocities by about {:.2g} of themselves; [bodies] follows it.\n",
                            turning);
}

}  // namespace mariotte::report
