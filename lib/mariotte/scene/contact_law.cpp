#include "mariotte/scene/contact_law.hpp"

#include <array>
#include <cmath>

#include "mariotte/contact/named_laws.hpp"

namespace mariotte::scene {
namespace {

using contact::NamedLaw;

constexpr double usual_exponent = 1.5;  ///< Hertz's, unless the law or the scene has another

const NamedLaw& read_name(const Source& source, const Field& field) {
  static const auto names = [] {
    std::array<std::string_view, std::size(contact::named_laws)> list;
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = contact::named_laws[i].name;
    return list;
  }();
  return contact::named_laws[choice(source, field, "law", names)];
}

double read_exponent(const Source& source, const LawTables& tables, Index contact, const NamedLaw& law) {
  const double own = law.exponent.value_or(usual_exponent);
  const auto field = tables.find_for(contact, "exponent");
  if (!field) return own;
  const double exponent = number(source, *field, dimension::none, Domain::finite);
  if (exponent < 1) reject(source, *field, fault::out_of_range, "must be at least 1");
  if (law.exponent && exponent != own)
    reject(source, *field, fault::misplaced,
           "law '" + std::string(law.name) + "' has its own exponent (viscoelastic has any)");
  return exponent;
}

/// The damping itself; a restitution takes its place.
double read_damping(const Source& source, const LawTables& tables, Index contact, const Field& law_field,
                    const NamedLaw& law, double exponent) {
  const auto field = tables.find_for(contact, "damping");
  const auto name = "law '" + std::string(law.name) + "'";
  if (!field && law.damping)
    reject(source, law_field, fault::missing, name + " needs a damping, or a restitution");
  if (!field) return 0;
  const auto unit = law.damping ? law.damping : dimension::damping;
  const double damping = number(source, *field, unit(exponent), Domain::not_negative);
  if (!law.damping && damping != 0)
    reject(source, *field, fault::misplaced, name + " has no damping (viscoelastic has)");
  return damping;
}

/// The restitution of a contact, unless its own table says a damping instead.
std::optional<Field> find_restitution(const Source& source, const LawTables& tables, Index contact) {
  const auto restitution = tables.find_for(contact, "restitution");
  const auto damping = tables.find_for(contact, "damping");
  if (!restitution || !damping) return restitution;
  const auto& own = tables.place_of(contact);
  const bool own_restitution = find(own, "restitution").has_value(),
             own_damping = find(own, "damping").has_value();
  if (own_restitution == own_damping)
    reject(source, *restitution, fault::contradiction, "'damping' is given, too; give one of them");
  return own_restitution ? restitution : std::nullopt;
}

Encounter read_encounter(const Source& source, const LawTables& tables, Index contact, const Field& field,
                         const Encounters& encounters, bool by_speed) {
  Encounter encounter{.reduced_mass = encounters.reduced_mass(contact), .speed = encounters.speed};
  if (const auto at = tables.find_for(contact, "at"))
    encounter.speed = number(source, *at, dimension::velocity, Domain::positive);
  if (!(encounter.speed > 0) && by_speed)
    reject(source, field, fault::missing,
           "needs 'at', the speed of approach it is meant for, since no balls approach at the start");
  if (!(encounter.speed > 0)) encounter.speed = 1;
  return encounter;
}

/// The damping that gives a restitution.
double solve_damping(const Source& source, const LawTables& tables, Index contact, const Field& field,
                     const NamedLaw& law, double stiffness, double exponent, Encounters& encounters) {
  const double e = number(source, field, dimension::none, Domain::positive);
  if (e > 1) reject(source, field, fault::out_of_range, "must not be above 1");
  if (e == 1) return 0;
  if (!law.damping)
    reject(source, field, fault::misplaced,
           "law '" + std::string(law.name) + "' has no damping (viscoelastic and hunt-crossley have)");
  const auto encounter =
      read_encounter(source, tables, contact, field, encounters, depends_on_speed(law, exponent));
  try {
    const auto damping = encounters.solver.damping(law, stiffness, exponent, e, encounter);
    if (!damping) reject(source, field, fault::out_of_range, "is smaller than any damping makes it");
    if (!(*damping > 0) || !std::isfinite(*damping))
      reject(source, field, fault::out_of_range, "has no damping that double precision can carry");
    return *damping;
  } catch (const InvalidParameter& error) {
    reject(source, field, error.fault, error.what());
  }
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
  if (exponent != usual_exponent)
    reject(source, law_field, fault::no_stiffness,
           "contact " + std::to_string(contact + 1) +
               " needs a stiffness (materials give it for the exponent 1.5 only)");
  return material_stiffness(source, law_field, contact, pair);
}

}  // namespace

contact::Law read_law(const Source& source, const LawTables& tables, Index contact, const BallPair& pair,
                      Encounters& encounters) {
  const auto field = tables.find_for(contact, "law");
  if (!field)
    reject(source, tables.place_of(contact), fault::missing,
           "'law' is missing (" + contact::names_of_laws() + ")");
  const auto& law = read_name(source, *field);
  const double exponent = read_exponent(source, tables, contact, law);
  if (const auto at = tables.find_for(contact, "at"); at && !tables.find_for(contact, "restitution"))
    reject(source, *at, fault::misplaced, "has no effect without 'restitution'");
  const auto restitution = find_restitution(source, tables, contact);
  const double given = restitution ? 0 : read_damping(source, tables, contact, *field, law, exponent);
  const double stiffness = read_stiffness(source, tables, contact, *field, exponent, pair);
  if (!restitution) return law.make(stiffness, given, exponent);
  return law.make(stiffness,
                  solve_damping(source, tables, contact, *restitution, law, stiffness, exponent, encounters),
                  exponent);
}

}  // namespace mariotte::scene
