// What a flow follows: one smooth autonomous field x' = f(x) with the guards that end it.
#pragma once
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/drives.hpp"
#include "mariotte/flow/linked_phase.hpp"
#include "mariotte/flow/serial_phase.hpp"
#include "mariotte/flow/tip_phase.hpp"

namespace mariotte::flow {

/// The way a guard must cross zero to fire; `none` masks it.
enum class Crossing : signed char { falling = -1, none = 0, rising = 1 };

class FreeMotion;
class RecordedPhase;

/// What an accepted step has done to the mode.
enum class Accepted {
  unchanged,
  rewatched,  ///< other guards are watched from here
  ended       ///< the mode is over here though no guard has fired
};

/// A structurally non-zero place of the Jacobian ∂f/∂x.
struct Entry {
  Index row;
  Index column;
  bool operator==(const Entry&) const = default;
};

/// A field of one mode, with everything dimensionless. All it says belongs to the present mode: a flow asks
/// before each phase whether sizes and pattern still fit. Implemented by the models.
class Problem {
 public:
  virtual ~Problem() = default;

  virtual Index size() const = 0;
  virtual void derivative(ConstState x, State dx) const = 0;

  virtual Index guard_count() const = 0;
  virtual void guards(ConstState x, State values) const = 0;
  /// Both of one state, which may have much in common.
  virtual void derivative_and_guards(ConstState x, State dx, State values) const {
    derivative(x, dx);
    guards(x, values);
  }
  /// Time derivatives of the guards, given dx = f(x).
  virtual void guard_rates(ConstState x, ConstState dx, State rates) const = 0;
  /// One crossing per guard.
  virtual std::span<const Crossing> crossings() const = 0;

  /// Natural size of each component: an error of accuracy × magnitude is what the user allows.
  virtual std::span<const double> magnitudes() const = 0;
  /// How large velocities are beside their natural size, at least 1: rounding of a large one blurs the rates
  /// of all.
  virtual double swiftness(ConstState /*x*/) const { return 1; }
  /// Shortest natural time of what is active.
  virtual double time_scale() const = 0;

  /// Places of the Jacobian that may not vanish, and their values, in the same order.
  virtual std::vector<Entry> pattern() const = 0;
  virtual void jacobian(ConstState x, State values) const = 0;
  /// Largest damping group c/√(k m) of the active contacts: what makes a phase stiff.
  virtual double damping_group() const = 0;
  /// Steps after which an explicit flow leaves the phase to an implicit one, where something else may be
  /// stiff.
  virtual Index trial_steps() const { return std::numeric_limits<Index>::max(); }
  /// Least load, over the natural force, whose sign matters at this accuracy: that of a contact which strong
  /// damping makes creep.
  virtual double least_load(double /*accuracy*/) const { return 1 / (damping_group() * damping_group()); }

  /// True if no force acts but constant accelerations. Unless the mode is a free body, x(t) is then
  /// x + t f(x) + t²/2 f'(x) f(x) exactly, and the guards are linear in x.
  virtual bool is_ballistic() const = 0;
  /// f'(x) f(x), asked of ballistic modes that are no free body.
  virtual void second_derivative(ConstState x, State ddx) const = 0;

  /// The present mode as a series of bodies, if it is one; follows every change of the mode.
  virtual const SerialPhase* serial() const { return nullptr; }
  /// The present mode as contacts that link dofs in any way, if it is that and no series.
  virtual const LinkedPhase* linked() const { return nullptr; }

  /// What drives either of them, if anything does.
  virtual const Drives* drives() const { return nullptr; }

  /// The present mode as one tip of a symmetric body on a plane, or as such a body in free flight.
  virtual const TipPhase* tip() const { return nullptr; }
  virtual const FreePhase* free_body() const { return nullptr; }
  /// The present mode if its field can be recorded.
  virtual const RecordedPhase* recorded() const { return nullptr; }
  /// The present ballistic mode if it knows its own closed form.
  virtual const FreeMotion* free_motion() const { return nullptr; }

  /// Told after every accepted step: a guard that starts at zero is watched only once it has left it, and
  /// what has sunk into rounding noise is no longer worth following.
  virtual Accepted accept(ConstState x) = 0;

  /// Name of a component for messages, such as "velocity 3".
  virtual std::string component(Index index) const = 0;
};

}  // namespace mariotte::flow
