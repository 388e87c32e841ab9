#include "mariotte/scene/contacts.hpp"

#include <array>
#include <cmath>

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 3> laws{"linear", "hertz", "viscoelastic"};
constexpr std::array<std::string_view, 4> keys{"law", "stiffness", "damping", "exponent"};
enum LawName : std::size_t { linear, hertz, viscoelastic };

/// The [[chain.contact]] tables: none, one for all, or one per contact.
std::vector<Field> read_tables(const Source& source, const Field& chain, const Layout& layout) {
  std::vector<Field> tables;
  const auto list = find(chain, "contact");
  if (!list) return tables;
  if (!list->node->array()) reject(source, *list, "write [[chain.contact]], with two brackets");
  const auto count = static_cast<Index>(list->node->array()->size());
  if (count != 1) expect_per_contact(source, *list, layout);
  for (Index j = 0; j < count; ++j) expect_keys(source, tables.emplace_back(element(*list, j)), keys);
  return tables;
}

/// Everything the scene says of the laws, for all contacts.
struct LawTables {
  Field chain;
  std::vector<Field> contacts;

  /// What it says of one contact under one key.
  std::optional<Field> find_for(Index contact, std::string_view key) const {
    if (!contacts.empty())
      if (auto own = find(contacts[contacts.size() == 1 ? 0 : contact], key)) return own;
    auto common = find(chain, key);
    return common && common->node->array() ? element(*common, contact) : common;
  }
};

double read_exponent(const Source& source, const LawTables& tables, Index contact, std::size_t law) {
  const double own = law == linear ? 1 : 1.5;
  const auto field = tables.find_for(contact, "exponent");
  if (!field) return own;
  const double exponent = number(source, *field, dimension::none, Domain::finite);
  if (exponent < 1) reject(source, *field, "must be at least 1");
  if (law != viscoelastic && exponent != own)
    reject(source, *field,
           "law '" + std::string(laws[law]) + "' has its own exponent (viscoelastic has any)");
  return exponent;
}

double read_damping(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                    std::size_t law, double exponent) {
  const auto field = tables.find_for(contact, "damping");
  if (!field && law == viscoelastic) reject(source, law_field, "law 'viscoelastic' needs a damping");
  if (!field) return 0;
  const double damping = number(source, *field, dimension::damping(exponent), Domain::not_negative);
  if (law != viscoelastic && damping != 0)
    reject(source, *field, "law '" + std::string(laws[law]) + "' has no damping (viscoelastic has)");
  return damping;
}

/// From the materials and radii of the two balls [N/m^1.5].
double material_stiffness(const Source& source, const Field& law_field, Index contact,
                          std::span<const Ball> balls) {
  const auto name = "contact " + std::to_string(contact + 1);
  const auto& a = balls[contact];
  const auto& b = balls[contact + 1];
  const auto elastic_a = elastic(a.material.value_or(Material{}));
  const auto elastic_b = elastic(b.material.value_or(Material{}));
  if (!elastic_a || !elastic_b || !a.radius || !b.radius)
    reject(source, law_field, name + " needs a stiffness, or radius, young and poisson of both its balls");
  const double stiffness = contact::hertz_stiffness(*elastic_a, *a.radius, *elastic_b, *b.radius);
  if (!(stiffness > 0) || !std::isfinite(stiffness))
    reject(source, law_field, name + " has no finite stiffness: two rigid bodies, or two planes");
  return stiffness;
}

double read_stiffness(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                      double exponent, std::span<const Ball> balls) {
  if (const auto field = tables.find_for(contact, "stiffness"))
    return number(source, *field, dimension::stiffness(exponent), Domain::positive);
  if (exponent != 1.5)
    reject(source, law_field,
           "contact " + std::to_string(contact + 1) +
               " needs a stiffness (materials give it for the exponent 1.5 only)");
  return material_stiffness(source, law_field, contact, balls);
}

contact::Law read_law(const Source& source, const LawTables& tables, Index contact,
                      std::span<const Ball> balls) {
  const auto field = tables.find_for(contact, "law");
  if (!field)
    reject(
        source,
        tables.contacts.empty() ? tables.chain : tables.contacts[tables.contacts.size() == 1 ? 0 : contact],
        "'law' is missing (linear, hertz or viscoelastic)");
  const auto law = choice(source, *field, "law", laws);
  const double exponent = read_exponent(source, tables, contact, law);
  const double damping = read_damping(source, tables, contact, *field, law, exponent);
  const double stiffness = read_stiffness(source, tables, contact, *field, exponent, balls);
  if (law == linear) return contact::Linear{.stiffness = stiffness};
  if (law == hertz) return contact::Hertz{.stiffness = stiffness};
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = exponent};
}

double read_gap(const Source& source, const Field& field, bool precompressed) {
  const double gap = number(source, field, dimension::length, Domain::finite);
  if (gap < 0 && !precompressed) reject(source, field, "must not be negative, unless precompressed = true");
  return gap;
}

}  // namespace

std::vector<contact::Law> read_laws(const Source& source, const Field& chain, const Layout& layout,
                                    std::span<const Ball> balls) {
  const LawTables tables{chain, read_tables(source, chain, layout)};
  for (const auto key : keys)
    if (const auto field = find(chain, key); field && field->node->array())
      expect_per_contact(source, *field, layout);
  std::vector<contact::Law> result;
  result.reserve(layout.contacts());
  for (Index j = 0; j < layout.contacts(); ++j) result.push_back(read_law(source, tables, j, balls));
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
