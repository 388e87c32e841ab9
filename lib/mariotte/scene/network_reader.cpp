#include "mariotte/scene/network_reader.hpp"

#include <algorithm>
#include <array>

#include "mariotte/core/error.hpp"
#include "mariotte/scene/contact_law.hpp"
#include "mariotte/scene/drive_reader.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/network_balls.hpp"

namespace mariotte::scene {
namespace {

constexpr auto network_keys = law_keys_and(
    std::array<std::string_view, 6>{"mass", "velocity", "contact", "gap", "precompressed", "drive"});
constexpr auto direction_keys = law_keys_and(std::array<std::string_view, 2>{"direction", "gap"});

/// The diagonal, or all rows one after the other. Units are those of the dofs, which only the author
/// knows.
model::MassMatrix read_mass(const Source& source, const Field& mass, std::size_t dofs) {
  const auto* const rows = mass.node->array();
  if (!rows || rows->empty() || !rows->front().array()) {
    auto diagonal = numbers(source, mass, dimension::none, Domain::positive_or_infinite);
    expect_length(source, mass, diagonal.size(), dofs);
    return diagonal;
  }
  expect_length(source, mass, rows->size(), dofs);
  model::MassMatrix all;
  for (std::size_t i = 0; i < dofs; ++i) {
    const auto field = element(mass, static_cast<Index>(i));
    const auto row = numbers(source, field, dimension::none, Domain::finite);
    expect_length(source, field, row.size(), dofs);
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

ContactDirection read_direction(const Source& source, const Field& contact, std::size_t dofs) {
  const auto field = find(contact, "direction");
  if (!field) reject(source, contact, fault::missing, "'direction' is missing (one value per velocity)");
  const auto all = numbers(source, *field, dimension::none, Domain::finite);
  expect_length(source, *field, all.size(), dofs);
  ContactDirection direction;
  for (std::size_t i = 0; i < dofs; ++i)
    if (all[i] != 0) direction.push_back({static_cast<Index>(i), all[i]});
  return direction;
}

double read_gap(const Source& source, const LawTables& tables, Index contact, bool precompressed) {
  const auto field = tables.find_for(contact, "gap");
  if (!field) return 0;
  const double gap = number(source, *field, dimension::length, Domain::finite);
  if (gap < 0 && !precompressed)
    reject(source, *field, fault::overlap, "must not be negative, unless precompressed = true");
  return gap;
}

LawTables read_tables(const Source& source, const Field& network) {
  LawTables tables{network, {}};
  const auto list = find(network, "contact");
  if (!list->node->array())
    reject(source, *list, fault::wrong_type, "write [[network.contact]], with two brackets");
  ErrorList errors;
  for (Index j = 0; j < std::ssize(*list->node->array()); ++j)
    errors.attempt(
        [&] { expect_keys(source, tables.contacts.emplace_back(element(*list, j)), direction_keys); });
  for (const auto key : law_keys_and(std::array<std::string_view, 1>{"gap"}))
    if (const auto field = find(network, key); field && field->node->array())
      errors.attempt(
          [&] { expect_length(source, *field, field->node->array()->size(), tables.contacts.size()); });
  errors.raise();
  return tables;
}

/// 1/(w M⁻¹ wᵀ) of a contact direction w.
double mass_of(const Source& source, const LawTables& tables, const model::Network& model, Index contact) {
  try {
    return reduced_mass(model, contact);
  } catch (const InvalidParameter& error) {
    reject(source, tables.place_of(contact), error.fault, error.what());
  }
}

void read_motion(const Source& source, const Field& network, model::Network& model) {
  const auto mass = find(network, "mass"), velocity = find(network, "velocity");
  if (!mass || !velocity)
    reject(source, network, fault::missing, "'mass' and 'velocity' are needed beside [[network.contact]]");
  model.velocity = numbers(source, *velocity, dimension::none, Domain::finite);
  model.mass = read_mass(source, *mass, model.velocity.size());
  read_drives(source, network, model);
}

/// Directions, laws and gaps.
void read_contacts(const Source& source, const LawTables& tables, model::Network& model) {
  ErrorList errors;
  for (const auto& contact : tables.contacts)
    errors.attempt(
        [&] { model.direction.push_back(read_direction(source, contact, model.velocity.size())); });
  if (!errors.empty()) errors.attempt([&] { check_laws(source, tables, std::ssize(tables.contacts)); });
  errors.raise();
  Encounters encounters{.reduced_mass = [&](Index j) { return mass_of(source, tables, model, j); },
                        .speed = largest_approach(model)};
  for (Index j = 0; j < std::ssize(tables.contacts); ++j) {
    errors.attempt_one_of_many([&] {
      model.law.push_back(read_law(source, tables, j, {nullptr, nullptr}, encounters));
    });
    errors.attempt_one_of_many(
        [&] { model.gap.push_back(read_gap(source, tables, j, model.precompressed)); });
  }
  errors.raise();
}

model::Network read_freedoms(const Source& source, const Field& network, bool precompressed) {
  model::Network model;
  model.precompressed = precompressed;
  LawTables tables{network, {}};
  ErrorList errors;
  errors.attempt([&] { expect_keys(source, network, network_keys); });
  const bool moves = errors.attempt([&] { read_motion(source, network, model); });
  const bool listed = errors.attempt([&] { tables = read_tables(source, network); });
  if (moves && listed)
    errors.attempt([&] { read_contacts(source, tables, model); });
  else if (listed)
    errors.attempt([&] { check_laws(source, tables, std::ssize(tables.contacts)); });
  errors.raise();
  return model;
}

}  // namespace

ResolvedNetwork read_network(Source& source, const Field& network) {
  if (!network.node->table()) expect_keys(source, network, network_keys);  // says that it is no table
  const bool balls = find(network, "ball").has_value(), contacts = find(network, "contact").has_value();
  if (balls == contacts)
    reject(source, network, balls ? fault::contradiction : fault::missing,
           "give either [[network.ball]], or 'mass', 'velocity' and [[network.contact]]");
  bool precompressed = false;
  if (const auto field = find(network, "precompressed")) precompressed = boolean(source, *field);
  return balls ? read_ball_network(source, network, precompressed)
               : ResolvedNetwork{read_freedoms(source, network, precompressed), {}};
}

}  // namespace mariotte::scene
