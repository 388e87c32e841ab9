#include "mariotte/scene/contacts.hpp"

#include "mariotte/scene/contact_law.hpp"

namespace mariotte::scene {
namespace {

/// The [[chain.contact]] tables: none, one for all, or one per contact.
std::vector<Field> read_tables(const Source& source, const Field& chain, const Layout& layout) {
  std::vector<Field> tables;
  const auto list = find(chain, "contact");
  if (!list) return tables;
  if (!list->node->array())
    reject(source, *list, fault::wrong_type, "write [[chain.contact]], with two brackets");
  const auto count = static_cast<Index>(list->node->array()->size());
  if (count != 1) expect_per_contact(source, *list, layout);
  for (Index j = 0; j < count; ++j) expect_keys(source, tables.emplace_back(element(*list, j)), law_keys);
  return tables;
}

/// Of neighbours at the start [m/s].
double largest_approach(std::span<const Ball> balls) {
  double most = 0;
  for (std::size_t j = 1; j < balls.size(); ++j)
    most = std::max(most, balls[j - 1].velocity.value_or(0) - balls[j].velocity.value_or(0));
  return most;
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
  const LawTables tables{chain, read_tables(source, chain, layout)};
  for (const auto key : law_keys)
    if (const auto field = find(chain, key); field && field->node->array())
      expect_per_contact(source, *field, layout);
  Encounters encounters{
      .reduced_mass = [&](Index j) { return reduced_mass(*balls[j].mass, *balls[j + 1].mass); },
      .speed = largest_approach(balls)};
  std::vector<contact::Law> result;
  result.reserve(layout.contacts());
  for (Index j = 0; j < layout.contacts(); ++j)
    result.push_back(read_law(source, tables, j, {&balls[j], &balls[j + 1]}, encounters));
  return result;
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
  for (Index j = 0; j < layout.contacts(); ++j)
    gaps.push_back(read_gap(source, element(*field, j), precompressed));
  return gaps;
}

}  // namespace mariotte::scene
