#include "mariotte/scene/contacts.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "mariotte/scene/contact_law.hpp"
#include "mariotte/scene/error_list.hpp"

namespace mariotte::scene {
namespace {

constexpr auto contact_keys = law_keys_and(std::array<std::string_view, 1>{"number"});

/// The contact that a table is about, from 0.
Index numbered(const Source& source, const Field& table, const Layout& layout) {
  const auto field = find(table, "number");
  if (!field)
    reject(source, table, fault::missing,
           "'number' is missing; either all tables of contacts have it, or none");
  return whole(source, *field, 1, layout.contacts()) - 1;
}

/// The [[chain.contact]] tables: none, one for all, one per contact, or some with their number.
LawTables read_tables(const Source& source, const Field& chain, const Layout& layout) {
  LawTables tables{chain, {}};
  const auto list = find(chain, "contact");
  if (!list) return tables;
  if (!list->node->array())
    reject(source, *list, fault::wrong_type, "write [[chain.contact]], with two brackets");
  const auto count = static_cast<Index>(list->node->array()->size());
  ErrorList errors;
  for (Index j = 0; j < count; ++j)
    errors.attempt(
        [&] { expect_keys(source, tables.contacts.emplace_back(element(*list, j)), contact_keys); });
  errors.raise();
  const auto has_number = [](const Field& table) { return find(table, "number").has_value(); };
  if (std::none_of(tables.contacts.begin(), tables.contacts.end(), has_number)) {
    if (count != 1) expect_per_contact(source, *list, layout);
    return tables;
  }
  for (const auto& table : std::exchange(tables.contacts, {}))
    if (const auto j = numbered(source, table, layout); !tables.numbered.emplace(j, table).second)
      reject(source, *find(table, "number"), fault::contradiction,
             "contact " + std::to_string(j + 1) + " was given before");
  return tables;
}

/// With one value per contact where [chain] has an array.
LawTables read_sized_tables(const Source& source, const Field& chain, const Layout& layout) {
  auto tables = read_tables(source, chain, layout);
  ErrorList errors;
  for (const auto key : law_keys)
    if (const auto field = find(chain, key); field && field->node->array())
      errors.attempt([&] { expect_per_contact(source, *field, layout); });
  errors.raise();
  return tables;
}

/// Of neighbours at the start [m/s].
double approach_of_neighbours(std::span<const Ball> balls) {
  double most = 0;
  for (std::size_t j = 1; j < balls.size(); ++j)
    most = std::max(most, balls[j - 1].velocity.value_or(0) - balls[j].velocity.value_or(0));
  return most;
}

/// Whether all contacts are said to have the same law.
bool are_common(const LawTables& tables) {
  const auto is_array = [&](std::string_view key) {
    const auto field = find(tables.whole, key);
    return field && field->node->array();
  };
  return tables.numbered.empty() && tables.contacts.size() <= 1 &&
         std::none_of(law_keys.begin(), law_keys.end(), is_array);
}

/// Whether balls make the same law with others.
bool are_alike(const Ball& a, const Ball& b) {
  return a.mass == b.mass && a.radius == b.radius && a.material == b.material;
}

double read_gap(const Source& source, const Field& field, bool precompressed) {
  const double gap = number(source, field, dimension::length, Domain::finite);
  if (gap < 0 && !precompressed)
    reject(source, field, fault::overlap, "must not be negative, unless precompressed = true");
  return gap;
}

}  // namespace

std::vector<contact::Law> read_laws(const Source& source, const Field& chain, const Layout& layout,
                                    std::span<const Ball> balls) {
  const auto tables = read_sized_tables(source, chain, layout);
  Encounters encounters{
      .reduced_mass = [&](Index j) { return reduced_mass(*balls[j].mass, *balls[j + 1].mass); },
      .speed = approach_of_neighbours(balls)};
  std::vector<contact::Law> result;
  result.reserve(layout.contacts());
  const bool common = are_common(tables);
  const auto is_as_before = [&](Index j) {  // rows are long
    return common && std::ssize(result) == j && j > 0 && are_alike(balls[j - 1], balls[j]) &&
           are_alike(balls[j], balls[j + 1]);
  };
  ErrorList errors;
  for (Index j = 0; j < layout.contacts(); ++j)
    errors.attempt_one_of_many([&] {
      result.push_back(is_as_before(j) ? result.back()
                                       : read_law(source, tables, j, {&balls[j], &balls[j + 1]}, encounters));
    });
  errors.raise();
  return result;
}

void check_laws(const Source& source, const Field& chain, const Layout& layout) {
  check_laws(source, read_sized_tables(source, chain, layout), layout.contacts());
}

std::vector<double> read_gaps(const Source& source, const Field& chain, const Layout& layout,
                              bool precompressed) {
  const auto field = find(chain, "gap");
  if (!field) return std::vector<double>(layout.contacts(), 0.0);
  if (!field->node->array())
    return std::vector<double>(layout.contacts(), read_gap(source, *field, precompressed));
  expect_per_contact(source, *field, layout);
  std::vector<double> gaps;
  gaps.reserve(layout.contacts());
  ErrorList errors;
  for (Index j = 0; j < layout.contacts(); ++j)
    errors.attempt_one_of_many([&] { gaps.push_back(read_gap(source, element(*field, j), precompressed)); });
  errors.raise();
  return gaps;
}

}  // namespace mariotte::scene
