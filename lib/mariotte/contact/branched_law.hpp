// A law with branches: it may pull, yield, remember and end at another indentation than it began.
#pragma once
#include <optional>

#include "mariotte/contact/brach_dunn.hpp"
#include "mariotte/contact/custom_law.hpp"
#include "mariotte/contact/memory.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/core/width_branch.hpp"

namespace mariotte::contact {

/// f = k (δ − δ₀)ⁿ + c (δ − δ₀)^q δ̇ − P: what many branches are.
struct ShiftedPower {
  double stiffness;                   ///< k [N/m^n]
  double exponent;                    ///< n
  double origin;                      ///< δ₀ [m]
  double damping = 0;                 ///< c [N s/m^n]
  double pull = 0;                    ///< P [N]
  Damping grows = Damping::as_slope;  ///< q, by n
};

/// A law f(δ, δ̇) on each branch of what the contact remembers. The force is not cut off where it pulls. What
/// ends a branch, and which comes next, is the automaton's [contact_set.hpp]; the law says where.
class BranchedLaw : public CustomLaw {
 public:
  /// Force of either sign and its slopes; goes on smoothly beyond where the contact ends.
  virtual Force force(const Memory& past, double indentation, double rate) const = 0;
  /// What the contact could give back, 0 where it is open [J]; negative in a well of adhesion. On the plastic
  /// branch as if it were unloaded from here.
  virtual double stored_energy(const Memory& past, double indentation) const = 0;
  /// Indentation at which it closes: 0, or the depth of its dent [m].
  virtual double closing_indentation(const Memory&) const { return 0; }
  /// Indentation at which it opens [m].
  virtual double opening_indentation(const Memory& past) const { return closing_indentation(past); }
  /// Indentation beyond which it yields [m]; infinite if it never does.
  virtual double yield_indentation(const Memory&) const { return infinity; }
  /// The force of the present branch if it is such a power; flows with closed forms follow it.
  virtual std::optional<ShiftedPower> power(const Memory&) const { return std::nullopt; }
  /// The present branch if it is a polynomial in the root of a contact radius; series follow it.
  virtual std::optional<WidthBranch> width_branch(const Memory&) const { return std::nullopt; }
  /// The law of a tip with a ring of adhesion, if it is that; series follow it.
  virtual std::optional<BrachDunn> adhesive_tip() const { return std::nullopt; }
  /// Indentation at which the force of the present branch rises through zero, if the law knows it.
  virtual std::optional<double> rest_indentation(const Memory&) const { return std::nullopt; }
  /// Energy lost to yielding up to an indentation of the plastic branch [J].
  virtual double plastic_loss(double /*peak*/) const { return 0; }
  /// True if the force can pull.
  virtual bool pulls() const = 0;
  /// True if it holds bodies at rest together: it closes however slowly they meet, and never lets go of its
  /// own.
  virtual bool adheres() const { return false; }
  /// True if the rate of indentation is watched for its sign.
  virtual bool watches_turns() const { return adheres(); }
  /// True if it has a damper.
  virtual bool is_damped() const = 0;

  Force force(double indentation, double rate) const final { return force(Memory{}, indentation, rate); }
  double stored_energy(double indentation) const final { return stored_energy(Memory{}, indentation); }
  bool dissipates() const final { return is_damped() || watches_turns(); }
  const BranchedLaw* branched() const final { return this; }
};

/// What a contact remembers changes where it begins and ends, with what adhesion gives and takes there; where
/// it has reached the indentation at which it yields; and where its rate of indentation changes its sign.
void begin(Memory& past, const BranchedLaw& law);
void end(Memory& past, const BranchedLaw& law);
void yield(Memory& past);
void turn(Memory& past, const BranchedLaw& law, double indentation);

/// Of a contact that has never been deeper than now.
inline Memory loaded_first(const BranchedLaw& law, double indentation) {
  Memory past;
  if (indentation > law.yield_indentation(past)) yield(past);
  return past;
}

/// Lost to yielding so far by a contact at this indentation [J].
inline double plastic_loss(const BranchedLaw& law, const Memory& past, double indentation) {
  const double depth = past.branch == Branch::plastic ? indentation : past.peak;
  return depth > 0 ? law.plastic_loss(depth) : 0;
}

/// The same law with δ, δ̇, force and energy in other units.
SharedLaw in_units(const BranchedLaw& law, const SharedLaw& owner, const Scale& scale);

}  // namespace mariotte::contact
