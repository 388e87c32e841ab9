#include "mariotte/impact/assess.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "mariotte/contact/limits.hpp"

namespace mariotte::impact {
namespace {

constexpr double hertz_exponent = 1.5;

/// Numbers that are not known are not finite.
void largest(Validity::Number& worst, double value, Index contact) {
  if (std::isfinite(value) && (!worst || value > worst->value)) worst = {value, contact};
}
void least(Validity::Number& worst, double value, Index contact) {
  if (std::isfinite(value) && (!worst || value < worst->value)) worst = {value, contact};
}

void assess_depth(Validity& validity, double indentation, const Touching& bodies, Index contact) {
  largest(validity.indentation_ratio, indentation / bodies.smaller_radius, contact);
  largest(validity.contact_radius_ratio, std::sqrt(indentation / bodies.radius), contact);
}

/// Of a Hertz contact.
void assess_pressure(Validity& validity, double indentation, double stiffness, const Touching& bodies,
                     Index contact) {
  const double modulus = contact::contact_modulus(stiffness, bodies.radius);
  const double pressure = contact::peak_pressure(modulus, bodies.radius, indentation);
  largest(validity.peak_pressure, pressure, contact);
  if (!(bodies.yield_strength > 0)) return;
  const double limit = contact::first_yield * bodies.yield_strength;
  largest(validity.yield_ratio, pressure / limit, contact);
  least(validity.first_yield_speed, contact::speed_of_pressure(modulus, bodies.radius, bodies.mass, limit),
        contact);
}

/// From closing to opening [s]; not finite if it is not over.
template <class Period>
double duration(const Period& period) {
  return period.end.value_or(infinity) - period.start;
}

/// The longest period of a contact [s]; not finite if it is not over at the end of the run.
template <class History>
double contact_time(const History& contact, double end) {
  double longest = 0, known = infinity;
  for (const auto& period : contact.periods) {
    if (period.end.value_or(end) - period.start <= longest) continue;
    longest = period.end.value_or(end) - period.start;
    known = duration(period);
  }
  return known;
}

/// A number of a law; NaN if it has none of this name.
double number_of(const std::vector<contact::LawParameter>& all, std::string_view key) {
  const auto found = std::ranges::find(all, key, &contact::LawParameter::key);
  return found == all.end() ? std::numeric_limits<double>::quiet_NaN() : found->value;
}

/// Stiffness of a law with Hertz's exponent that does not yield [N/m^{3/2}]; else 0 or NaN. What has no
/// exponent of its own has Hertz's.
double hertz_stiffness(const contact::Law& law) {
  if (const auto* power = contact::power_law(law))
    return power->exponent == hertz_exponent ? power->stiffness : 0;
  const auto all = contact::parameters(law);
  const double exponent = number_of(all, "exponent"), radius = number_of(all, "effective_radius");
  if (std::isfinite(number_of(all, "yield_pressure"))) return 0;
  if (std::isfinite(radius)) return contact::contact_stiffness(number_of(all, "effective_modulus"), radius);
  return std::isnan(exponent) || exponent == hertz_exponent ? number_of(all, "stiffness") : 0;
}

/// Of a law whose adhesion acts on the edge of the contact; NaN of any other.
double tabor_number(const contact::Law& law) {
  if (contact::power_law(law) || contact::name(law) == "dmt") return std::numeric_limits<double>::quiet_NaN();
  const auto all = contact::parameters(law);
  return contact::tabor_number(number_of(all, "effective_modulus"), number_of(all, "effective_radius"),
                               number_of(all, "work_of_adhesion"));
}

/// Indentation of the last point of a table; not finite of any other law [m].
double end_of_table(const contact::Law& law) {
  if (contact::power_law(law)) return std::numeric_limits<double>::quiet_NaN();
  return number_of(contact::parameters(law), "largest_indentation");
}

/// Contact j of a result, which has this law.
template <class History>
void assess_contact(Validity& validity, const History& one, const contact::Law& law, const Touching& touching,
                    Index j, double end) {
  if (!(one.peak_indentation > 0)) return;
  largest(validity.table_ratio, one.peak_indentation / end_of_table(law), j);
  least(validity.tabor_number, tabor_number(law), j);
  if (!(touching.radius > 0)) return;
  assess_depth(validity, one.peak_indentation, touching, j);
  if (const double stiffness = hertz_stiffness(law); stiffness > 0)
    assess_pressure(validity, one.peak_indentation, stiffness, touching, j);
  least(validity.contact_time_ratio, contact_time(one, end) / touching.wave_travel, j);
}

template <class Impact>
void refuse_depth(Impact& impact, const char* thing) {
  const auto& worst = impact.validity.indentation_ratio;
  if (!worst || !(worst->value > 1) || impact.ending == hybrid::Ending::failed) return;
  std::ostringstream message;
  message << thing << " " << worst->contact + 1 << " is indented by " << worst->value
          << " times the radius of its body; no contact law holds beyond the radius";
  impact.ending = hybrid::Ending::invalid;
  impact.message = message.str();
}

/// What is known of a contact's bodies; a scene without radii has no list.
Touching known(std::span<const Touching> touching, Index contact) {
  return touching.empty() ? Touching{} : touching[contact];
}

}  // namespace

void assess(ContactImpact& impact, std::span<const contact::Law> laws, std::span<const Touching> touching) {
  impact.validity = {};
  for (Index j = 0; j < std::ssize(impact.contacts); ++j)
    assess_contact(impact.validity, impact.contacts[j], laws[j], known(touching, j), j, impact.time);
  refuse_depth(impact, "contact");
}

void assess(BodiesImpact& impact, const model::Bodies& bodies, std::span<const Touching> touching) {
  impact.validity = {};
  for (Index j = 0; j < std::ssize(impact.contacts); ++j) {
    const auto& one = impact.contacts[j];
    assess_contact(impact.validity, one, bodies.contact[one.contact].law, known(touching, one.contact), j,
                   impact.time);
  }
  refuse_depth(impact, "contact");
}

void assess(MicrobodyImpact& impact, const model::Microbody& body, std::span<const Touching> touching) {
  auto& validity = impact.validity = {};
  for (const auto& one : impact.impacts) {
    const auto& law = body.law[one.tip];
    const double speed = std::max(std::abs(one.normal_velocity_in), std::abs(one.normal_velocity_out));
    largest(validity.hertz_damping, law.damping_hertz * speed, one.tip);
    largest(validity.adhesion_damping, law.damping_adhesion * speed, one.tip);
    assess_depth(validity, one.peak_indentation, touching[one.tip], one.tip);
    assess_pressure(validity, one.peak_indentation, law.stiffness, touching[one.tip], one.tip);
    least(validity.contact_time_ratio, duration(one) / touching[one.tip].wave_travel, one.tip);
    if (!(law.adhesion > 0)) continue;
    largest(validity.adhesion_ratio, contact::rest_indentation(law) / touching[one.tip].radius, one.tip);
    least(validity.tabor_number, contact::tabor_number(law, touching[one.tip].radius), one.tip);
    largest(validity.well_damping, contact::well_damping(law, body.body.mass), one.tip);
  }
  refuse_depth(impact, "tip");
}

bool has_validity(std::span<const contact::Law> laws, std::span<const Touching> touching) {
  return !touching.empty() ||
         std::ranges::any_of(laws, [](const auto& law) { return std::isfinite(end_of_table(law)); });
}

}  // namespace mariotte::impact
