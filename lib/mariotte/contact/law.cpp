#include "mariotte/contact/law.hpp"

#include <string>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/core/error.hpp"

namespace mariotte::contact {
namespace {

double stored_energy(const CustomLaw& law, double indentation) {
  return law.stored_energy(indentation);
}

const PowerLaw& expect_power_law(const Law& law) {
  if (const auto* power = power_law(law)) return *power;
  throw InvalidParameter("the law '" + std::string(name(law)) + "' is no power law");
}

}  // namespace

double stored_energy(const Law& law, double indentation) {
  return with(law, [&](const auto& one) { return stored_energy(one, indentation); });
}

bool is_damped(const Law& law) {
  const auto* branches = branched(law);
  return branches ? branches->is_damped() : dissipates(law);
}

bool pulls(const Law& law) {
  const auto* branches = branched(law);
  return branches && branches->pulls();
}
bool adheres(const Law& law) {
  const auto* branches = branched(law);
  return branches && branches->adheres();
}
bool watches_turns(const Law& law) {
  const auto* branches = branched(law);
  return branches && branches->watches_turns();
}

std::optional<double> find_static_indentation(const Law& law, double force) {
  if (const auto* power = power_law(law)) return static_indentation(*power, force);
  return find_static_indentation(*std::get<SharedLaw>(law), force);
}

double static_indentation(const Law& law, double force) {
  if (const auto found = find_static_indentation(law, force)) return *found;
  throw InvalidParameter("the law '" + std::string(name(law)) +
                         "' never comes to the force that its contact carries at rest");
}

std::string_view name(const Law& law) {
  if (const auto* power = power_law(law)) return name(*power);
  return std::get<SharedLaw>(law)->name();
}

std::vector<LawParameter> parameters(const Law& law) {
  if (const auto* power = power_law(law))
    return {{"stiffness", power->stiffness}, {"damping", power->damping}, {"exponent", power->exponent}};
  return std::get<SharedLaw>(law)->parameters();
}

double stiffness(const Law& law) {
  return expect_power_law(law).stiffness;
}
double damping(const Law& law) {
  return expect_power_law(law).damping;
}
double exponent(const Law& law) {
  return expect_power_law(law).exponent;
}

}  // namespace mariotte::contact
