#include "mariotte/model/contacts/start_balance.hpp"

#include "mariotte/contact/branched_law.hpp"

namespace mariotte::model {
namespace {

/// Of a contact that has never been deeper.
contact::Force start_force(const contact::Law& law, double indentation) {
  const auto* branched = contact::branched(law);
  return branched ? branched->force(contact::loaded_first(*branched, indentation), indentation, 0)
                  : contact::force(law, indentation, 0);
}

}  // namespace

std::vector<double> start_forces(const StatedContacts& stated) {
  std::vector<double> force(stated.law.size(), 0);
  for (std::size_t j = 0; j < force.size(); ++j)
    if (stated.gap[j] < 0) force[j] = start_force(stated.law[j], -stated.gap[j]).value;
  return force;
}

double unbalanced_speeds(const StatedContacts& stated, const std::vector<double>& reduced_mass,
                         const std::vector<double>& approach) {
  constexpr double near = 1e-4;  // of the energy
  double sum = 0;
  for (std::size_t j = 0; j < approach.size(); ++j) {
    if (!(stated.gap[j] < 0)) continue;
    const double indentation = -stated.gap[j], mass = reduced_mass[j];
    const double stiffness = start_force(stated.law[j], indentation).by_indentation;
    const double released = 2 * contact::stored_energy(stated.law[j], indentation) / mass;
    const double unbalanced = approach[j] * approach[j] * mass / stiffness;
    if (!(stiffness > 0) || !(unbalanced <= near * released)) return infinity;
    sum += unbalanced;
  }
  return sum;
}

}  // namespace mariotte::model
