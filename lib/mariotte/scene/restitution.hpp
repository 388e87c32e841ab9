// From a coefficient of restitution to the damping that gives it, and back.
//
// A pair alone is a reduced mass m* that strikes a wall: m* δ̈ = −f(δ, δ̇) from δ = 0, δ̇ = v until the force
// ends, and e = −δ̇/v then. In units of m*, of v, and of the length L with k Lⁿ = m* v²/L the stiffness is 1,
// so e depends on exponent and dimensionless damping alone.
#pragma once
#include <map>
#include <optional>
#include <tuple>

#include "mariotte/contact/brach_dunn.hpp"
#include "mariotte/contact/named_laws.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::scene {

/// Two bodies about to meet.
struct Encounter {
  double reduced_mass = 0;  ///< m₁ m₂/(m₁ + m₂), of a contact direction w: 1/(w M⁻¹ wᵀ) [kg]
  double speed = 0;         ///< of approach [m/s]
};

/// m₁ m₂/(m₁ + m₂); a wall has infinite mass [kg].
double reduced_mass(double left, double right);

double reduced_mass(const model::Chain& chain, Index contact);
double reduced_mass(const model::Network& network, Index contact);

/// The largest speed at which bodies of a contact approach each other at the start [m/s]; 0 if none do.
double largest_approach(const model::Chain& chain);
double largest_approach(const model::Network& network);

/// e of a contact between bodies that nothing else touches.
double restitution(const contact::Law& law, const Encounter& encounter);

/// e of a sphere that strikes a plane head on; its mass is the reduced one.
double restitution(const contact::BrachDunn& law, double radius, const Encounter& encounter);

/// A law by its name, and whether it is cut off where its force would pull.
struct LawChoice {
  const contact::NamedLaw& law;
  bool uncut = false;

  contact::Law make(const contact::LawNumbers& numbers) const {
    auto made = law.make(numbers);
    return uncut && contact::dissipates(made) ? contact::uncut(std::move(made)) : made;
  }
};

/// Finds dampings, and remembers them.
class DampingSolver {
 public:
  /// The damping, in the unit of the law, with which a pair alone has the restitution 0 < e ≤ 1: every law
  /// reaches all of them, e ~ 1/a or less at large dampings. Infinite if that is 10¹¹ of its natural unit or
  /// more, empty if adhesion alone takes more.
  std::optional<double> damping(const LawChoice& law, const contact::LawNumbers& numbers, double restitution,
                                const Encounter& encounter);

 private:
  std::map<std::tuple<std::string_view, bool, double, double>, std::optional<double>>
      found_;  // dimensionless
};

/// C_H with which a sphere of this mass [kg] that strikes the surface head on at this speed [m/s] has the
/// restitution; infinite if it is too large to be computed with, empty where adhesion damping alone takes
/// more.
std::optional<double> hertz_damping(const contact::Surface& surface, double radius, double damping_adhesion,
                                    double restitution, double mass, double speed);

/// Whether e of this law depends on the speed of approach.
bool depends_on_speed(const contact::NamedLaw& law, double exponent);

}  // namespace mariotte::scene
