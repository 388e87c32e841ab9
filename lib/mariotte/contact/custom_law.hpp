// A contact law that the library does not know: its force, its energy and its name are all that is asked for.
#pragma once
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "mariotte/contact/force.hpp"
#include "mariotte/core/cubic_curve.hpp"
#include "mariotte/core/damping.hpp"
#include "mariotte/core/scale.hpp"

namespace mariotte::contact {

/// A number of a law, as results and messages show it.
struct LawParameter {
  std::string_view key;
  double value;
};

/// f = k δⁿ + c δ^q δ̇.
struct DampedPower {
  double stiffness;  ///< k [N/m^n]
  double exponent;   ///< n
  double damping;    ///< c [N s/m^(q+1)]
  Damping grows;     ///< q, by n
};

class BranchedLaw;

/// A law f(δ, δ̇) without memory, in SI units. CVODE follows it; of the flows with closed forms and series,
/// these follow it which can follow its powers or its segments. Objects are shared by contacts and threads,
/// so they must not change.
class CustomLaw {
 public:
  virtual ~CustomLaw() = default;

  virtual std::string_view name() const = 0;
  /// Force [N] of either sign and its slopes at δ ≥ 0 [m] and any rate [m/s]. It is cut off where it pulls.
  /// Slopes must be finite; for a law that does not dissipate the rate must not matter.
  virtual Force force(double indentation, double rate) const = 0;
  /// Elastic energy [J] at δ ≥ 0: 0 at 0, and grows with δ. Its slope is the force of a law that does not
  /// dissipate.
  virtual double stored_energy(double indentation) const = 0;
  /// True if the force depends on the rate. What the contact takes up and does not store is then lost.
  virtual bool dissipates() const { return false; }
  /// A smooth function with the sign of the force at δ > 0, with slopes, best without the factors that make
  /// the force flat where it vanishes: its zero ends a contact that dissipates and is still indented.
  virtual Force load(double indentation, double rate) const { return force(indentation, rate); }
  /// Indentation [m] at which an energy [J] is stored; found by bisection unless the law knows better.
  virtual double natural_indentation(double energy) const;
  /// The force if it is a sum of such powers.
  virtual std::optional<DampedPower> powers() const { return std::nullopt; }
  /// The force as cubic segments, if it is that; series follow them.
  virtual const CubicCurve* curve() const { return nullptr; }
  /// Numbers of the law for results.
  virtual std::vector<LawParameter> parameters() const { return {}; }
  /// The law itself if it has branches, which only the library's own have.
  virtual const BranchedLaw* branched() const { return nullptr; }
};

/// How a law of one's own is handed to a model.
using SharedLaw = std::shared_ptr<const CustomLaw>;

/// The force goes on past δ = 0 along its tangent, so that a step which reaches beyond meets no kink.
Force smooth_force(const CustomLaw& law, double indentation, double rate);
/// The load likewise.
Force load(const CustomLaw& law, double indentation, double rate);

/// Indentation at which the contact carries a force at rest [m], loaded for the first time; none if it never
/// carries that much.
std::optional<double> find_static_indentation(const CustomLaw& law, double force);

/// The same law with δ, δ̇, force and energy in other units. Throws InvalidParameter if no indentation
/// stores the unit of energy.
SharedLaw in_units(const SharedLaw& law, const Scale& scale);

}  // namespace mariotte::contact
