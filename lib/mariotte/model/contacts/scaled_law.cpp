#include "mariotte/model/contacts/scaled_law.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::model {

contact::Law scaled(const contact::Law& law, const Scale& scale, const contact::Law& reference) {
  const auto *power = power_law(law), *unit = power_law(reference);
  if (!power) return contact::in_units(std::get<contact::SharedLaw>(law), scale);
  const double n = power->exponent;
  const double stiffness = unit && n == unit->exponent
                               ? power->stiffness / unit->stiffness
                               : power->stiffness * std::pow(scale.length, n + 1) / scale.energy();
  const double damping =
      power->damping == 0 ? 0 : power->damping * std::pow(scale.length, n) / scale.momentum();
  return contact::PowerLaw{.stiffness = stiffness, .damping = damping, .exponent = n};
}

double NaturalLength::operator()(const contact::Law& law, double mass, double speed) {
  const auto* power = power_law(law);
  if (!power) return std::get<contact::SharedLaw>(law)->natural_indentation(0.5 * mass * speed * speed);
  const double q = mass * speed * speed / power->stiffness;
  if (q != q_ || power->exponent != exponent_) length_ = natural_root(q, power->exponent);
  q_ = q;
  exponent_ = power->exponent;
  return length_;
}

contact::PowerLaw seen_by_flows(const contact::Law& law) {
  const auto* power = power_law(law);
  return power ? *power : contact::PowerLaw{.stiffness = 0, .exponent = 1};
}

double slow_share(double accuracy) {
  return std::max(0.1 * accuracy, 8 * epsilon);
}

}  // namespace mariotte::model
