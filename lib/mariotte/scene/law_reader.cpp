#include "mariotte/scene/law_reader.hpp"

#include <array>

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 6> law_table_keys{"mass",      "velocity",     "icr",
                                                         "direction", "energy_ratio", "frame"};
constexpr std::array<std::string_view, 2> frames{"given", "mass-centre"};

std::vector<double> read_direction(const Source& source, const Field& law) {
  const auto icr = find(law, "icr"), direction = find(law, "direction");
  if (icr && direction)
    reject(source, *direction, fault::contradiction, "'law.icr' gives the direction, too");
  if (direction) return numbers(source, *direction, dimension::none, Domain::finite);
  if (icr) return impact::direction_of_ratios(numbers(source, *icr, dimension::none, Domain::finite));
  return {};
}

}  // namespace

Law read_law(const Source& source, const Field& table) {
  expect_keys(source, table, law_table_keys);
  Law law;
  const auto mass = find(table, "mass"), velocity = find(table, "velocity");
  if (mass.has_value() != velocity.has_value())
    reject(source, table, fault::missing, "'mass' and 'velocity' belong together");
  if (mass) {
    law.mass = numbers(source, *mass, dimension::mass, Domain::positive_or_infinite);
    law.velocity = numbers(source, *velocity, dimension::velocity, Domain::finite);
    expect_length(source, *velocity, law.velocity.size(), law.mass.size());
  }
  law.direction = read_direction(source, table);
  if (mass && !law.direction.empty()) {
    const auto icr = find(table, "icr");
    expect_length(source, icr ? *icr : *find(table, "direction"), law.direction.size() - (icr ? 1 : 0),
                  law.mass.size() - (icr ? 2 : 1));
  }
  if (const auto e = find(table, "energy_ratio"))
    law.energy_ratio = number(source, *e, dimension::none, Domain::not_negative);
  if (const auto frame = find(table, "frame"))
    law.frame = static_cast<impact::EnergyFrame>(choice(source, *frame, "frame", frames));
  return law;
}

}  // namespace mariotte::scene
