#include "mariotte/scene/contact_law.hpp"

#include <array>
#include <cmath>

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 3> laws{"linear", "hertz", "viscoelastic"};
enum LawName : std::size_t { linear, hertz, viscoelastic };

double read_exponent(const Source& source, const LawTables& tables, Index contact, std::size_t law) {
  const double own = law == linear ? 1 : 1.5;
  const auto field = tables.find_for(contact, "exponent");
  if (!field) return own;
  const double exponent = number(source, *field, dimension::none, Domain::finite);
  if (exponent < 1) reject(source, *field, fault::out_of_range, "must be at least 1");
  if (law != viscoelastic && exponent != own)
    reject(source, *field, fault::misplaced,
           "law '" + std::string(laws[law]) + "' has its own exponent (viscoelastic has any)");
  return exponent;
}

double read_damping(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                    std::size_t law, double exponent) {
  const auto field = tables.find_for(contact, "damping");
  if (!field && law == viscoelastic)
    reject(source, law_field, fault::missing, "law 'viscoelastic' needs a damping");
  if (!field) return 0;
  const double damping = number(source, *field, dimension::damping(exponent), Domain::not_negative);
  if (law != viscoelastic && damping != 0)
    reject(source, *field, fault::misplaced,
           "law '" + std::string(laws[law]) + "' has no damping (viscoelastic has)");
  return damping;
}

/// From the materials and radii of the two balls [N/m^1.5].
double material_stiffness(const Source& source, const Field& law_field, Index contact, const BallPair& pair) {
  const auto name = "contact " + std::to_string(contact + 1);
  const auto [a, b] = pair;
  const auto elastic_of = [](const Ball* ball) {
    return ball ? elastic(ball->material.value_or(Material{})) : std::nullopt;
  };
  const auto elastic_a = elastic_of(a), elastic_b = elastic_of(b);
  if (!elastic_a || !elastic_b || !a->radius || !b->radius)
    reject(source, law_field, fault::no_stiffness,
           name + " needs a stiffness, or radius, young and poisson of both its balls");
  const double stiffness = contact::hertz_stiffness(*elastic_a, *a->radius, *elastic_b, *b->radius);
  if (!(stiffness > 0) || !std::isfinite(stiffness))
    reject(source, law_field, fault::no_stiffness,
           name + " has no finite stiffness: two rigid bodies, or two planes");
  return stiffness;
}

double read_stiffness(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                      double exponent, const BallPair& pair) {
  if (const auto field = tables.find_for(contact, "stiffness"))
    return number(source, *field, dimension::stiffness(exponent), Domain::positive);
  if (exponent != 1.5)
    reject(source, law_field, fault::no_stiffness,
           "contact " + std::to_string(contact + 1) +
               " needs a stiffness (materials give it for the exponent 1.5 only)");
  return material_stiffness(source, law_field, contact, pair);
}

}  // namespace

contact::Law read_law(const Source& source, const LawTables& tables, Index contact, const BallPair& pair) {
  const auto field = tables.find_for(contact, "law");
  if (!field)
    reject(source, tables.place_of(contact), fault::missing,
           "'law' is missing (linear, hertz or viscoelastic)");
  const auto law = choice(source, *field, "law", laws);
  const double exponent = read_exponent(source, tables, contact, law);
  const double damping = read_damping(source, tables, contact, *field, law, exponent);
  const double stiffness = read_stiffness(source, tables, contact, *field, exponent, pair);
  if (law == linear) return contact::Linear(stiffness);
  if (law == hertz) return contact::Hertz(stiffness);
  return contact::PowerLaw{.stiffness = stiffness, .damping = damping, .exponent = exponent};
}

}  // namespace mariotte::scene
