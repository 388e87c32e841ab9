#include "mariotte/model/contacts/scaled_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/natural_root.hpp"

namespace mariotte::model {
namespace {

/// The indentation L of a contact that a mass strikes at a speed: k L^{n+1} = m v² of a power law, and where
/// any other law stores m v²/2.
class NaturalLength {
 public:
  double operator()(const contact::Law& law, double mass, double speed) {
    const auto* power = power_law(law);
    if (!power) return of_other(*std::get<contact::SharedLaw>(law), 0.5 * mass * speed * speed);
    return root_(mass * speed * speed / power->stiffness, power->exponent);
  }

 private:
  double of_other(const contact::CustomLaw& law, double energy) {
    if (other_ != &law || energy != energy_) other_length_ = law.natural_indentation(energy);
    other_ = &law;
    energy_ = energy;
    return other_length_;
  }

  NaturalRoot root_;
  // Of the last answer: contacts of a model are mostly alike.
  const contact::CustomLaw* other_ = nullptr;
  double energy_ = 0, other_length_ = 0;
};

std::size_t quickest_contact(const std::vector<contact::Law>& law, const std::vector<double>& mass,
                             double speed, NaturalLength& natural_length) {
  std::size_t quickest = 0;
  double shortest = infinity;
  for (std::size_t j = 0; j < law.size(); ++j) {
    const double length = natural_length(law[j], mass[j], speed);
    if (length >= shortest) continue;
    shortest = length;
    quickest = j;
  }
  return quickest;
}

/// c L^n/(M V).
double scaled_damping(const contact::PowerLaw& law, const Scale& scale) {
  if (law.damping == 0) return 0;
  return law.damping * (contact::contact_width(law.exponent, scale.length) * scale.length) / scale.momentum();
}

/// k L^{n+1}/(M V²) and c L^n/(M V) of a power law. Any other law is asked in its own units.
contact::Law in_units(const contact::Law& law, const Scale& scale) {
  const auto* power = power_law(law);
  if (!power) return contact::in_units(std::get<contact::SharedLaw>(law), scale);
  const double n = power->exponent, square = scale.length * scale.length;
  return contact::PowerLaw{
      .stiffness = power->stiffness * (contact::contact_width(n, scale.length) * square) / scale.energy(),
      .damping = scaled_damping(*power, scale),
      .exponent = n};
}

/// A law with the reference's exponent divides by its stiffness instead of going through L, which makes the
/// reference's own stiffness exactly 1.
contact::Law scaled(const contact::Law& law, const Scale& scale, const contact::Law& reference) {
  const auto *power = power_law(law), *unit = power_law(reference);
  if (!power || !unit || power->exponent != unit->exponent) return in_units(law, scale);
  return contact::PowerLaw{.stiffness = power->stiffness / unit->stiffness,
                           .damping = scaled_damping(*power, scale),
                           .exponent = power->exponent};
}

/// Contact j in these units; contacts that share a law go on sharing it.
contact::Law scaled(const StatedContacts& stated, std::size_t j, const Scale& scale,
                    const contact::Law& reference, const std::vector<contact::Law>& done) {
  const auto shared = [&](std::size_t i) { return std::get_if<contact::SharedLaw>(&stated.law[i]); };
  if (j > 0 && shared(j) && shared(j - 1) && *shared(j) == *shared(j - 1)) return done.back();
  return scaled(stated.law[j], scale, reference);
}

}  // namespace

void SquaredSpeeds::release(const contact::Law& law, double indentation, double mass) {
  const double squared = 2 * std::max(0.0, contact::stored_energy(law, indentation)) / mass;
  const auto force = contact::force(law, indentation, 0);
  const double held = force.by_rate > 0 ? force.value / force.by_rate : infinity;
  released += squared;
  let_through += contact::pulls(law) ? squared : std::min(squared, held * held);
}

double SquaredSpeeds::in_balance() const {
  constexpr double least = 1e-9;
  const double vibration = std::min(given + driven_changes + unbalanced, before());
  const double share = before() > 0 ? std::sqrt(vibration / before()) : 1;
  return std::max(share, least);
}

double SquaredSpeeds::accurate_share() const {
  constexpr double rounding = 64 * epsilon;
  const bool is_at_rest = given + driven == 0 && unbalanced <= rounding * rounding * before();
  return is_at_rest ? 1 : in_balance();
}

void SquaredSpeeds::drive(const Drive& drive, double inverse_mass) {
  auto changes = drive;
  for (auto& piece : changes.signal.piece) piece.power[0] -= start_force(drive);
  const double speed = driven_speed(drive, inverse_mass), change = driven_speed(changes, inverse_mass);
  driven += speed * speed;
  driven_changes += change * change;
}

void take_speeds(const SquaredSpeeds& speeds, ScaledContacts& d) {
  d.scale.refinement = speeds.refinement();
  d.reached_speed = speeds.all() > 0 ? d.speed * std::sqrt(speeds.reached() / speeds.all()) : d.speed;
}

void scale_contacts(const StatedContacts& stated, double speed, double accuracy, ScaledContacts& d) {
  NaturalLength natural_length, slow_length;
  const auto quickest = quickest_contact(stated.law, d.reduced_mass, speed, natural_length);
  d.scale.mass = power_of_two_below(2 * d.reduced_mass[quickest]);
  d.scale.velocity = power_of_two_below(speed);
  d.scale.length = natural_length(stated.law[quickest], d.scale.mass, d.scale.velocity);
  d.scale.time = d.scale.length / d.scale.velocity;
  d.speed = speed / d.scale.velocity;
  d.noise_speed = noise_share(accuracy) * d.speed;
  d.fade_speed_ratio = d.fade_depth_ratio = 1;
  for (auto* list : {&d.gap, &d.velocity, &d.length, &d.time, &d.noise_depth}) list->clear();
  d.law.clear();
  for (const double v : stated.velocity) d.velocity.push_back(v / d.scale.velocity);
  for (std::size_t j = 0; j < stated.law.size(); ++j) {
    const auto& law = d.law.emplace_back(scaled(stated, j, d.scale, stated.law[quickest], d.law));
    d.gap.push_back(stated.gap[j] / d.scale.length);
    d.reduced_mass[j] /= d.scale.mass;
    d.length.push_back(natural_length(law, d.reduced_mass[j], d.speed));
    d.time.push_back(d.length[j] / d.speed);
    d.noise_depth.push_back(slow_length(law, d.reduced_mass[j], d.noise_speed));
  }
}

void restate_contacts(const StatedContacts& stated, ScaledContacts& d) {
  for (std::size_t i = 0; i < stated.velocity.size(); ++i)
    d.velocity[i] = stated.velocity[i] / d.scale.velocity;
  for (std::size_t j = 0; j < stated.law.size(); ++j) {
    d.law[j] = in_units(stated.law[j], d.scale);
    d.gap[j] = stated.gap[j] / d.scale.length;
  }
}

double noise_share(double accuracy) {
  return std::max(0.1 * accuracy, 8 * epsilon);
}

double damping_group(const ScaledContacts& scaled, Index j) {
  if (!contact::is_damped(scaled.law[j])) return 0;
  const double slope = contact::smooth_force(scaled.law[j], scaled.length[j], 0).by_rate;
  return slope * scaled.time[j] / scaled.reduced_mass[j];
}

}  // namespace mariotte::model
