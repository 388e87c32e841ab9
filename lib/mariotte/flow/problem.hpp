// What a flow follows: one smooth autonomous field x' = f(x) with the guards that end it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/pair_motion.hpp"

namespace mariotte::flow {

/// The way a guard must cross zero to fire; `none` masks it.
enum class Crossing : signed char { falling = -1, none = 0, rising = 1 };

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

/// A phase in which two bodies push each other through one contact and everything else flies freely at
/// constant velocity: where its quantities stand in the state. −1 for what does not exist.
struct PairPhase {
  PairLaw law;
  double left_share;              ///< m*/m of the left body: what it takes of a change of δ̇
  double right_share;             ///< m*/m of the right body
  Index left, right;              ///< velocities; δ̇ = x[left] − x[right]
  Index gap;                      ///< δ = −x[gap]
  Index work;                     ///< ∫ f δ̇ dt
  Index impulse;                  ///< ∫ f dt
  Index guard;                    ///< that fires when the contact lets go
  Index left_gap, right_gap;      ///< gaps of the two bodies to their other neighbours
  Index left_guard, right_guard;  ///< guards of these gaps
};

/// A phase in which all forces are those of linear contacts, f = k δ + c δ̇, between bodies in a row: where
/// its quantities stand in the state. −1 for what does not exist.
struct LinearPhase {
  struct Body {
    Index velocity;
    double inverse_mass;
  };
  /// Contact j joins bodies j and j + 1.
  struct Contact {
    enum class State : unsigned char { open, closed, slack };
    State state;
    Index gap;         ///< δ = −x[gap]
    Index work;        ///< ∫ f δ̇ dt
    Index impulse;     ///< ∫ f dt
    Index gap_guard;   ///< falling where the contact is open, rising where it is not
    Index load_guard;  ///< of damped contacts k δ + c δ̇: falling where closed, rising where slack
    double stiffness;  ///< k
    double damping;    ///< c
    double level;      ///< an open contact closes where its gap is −level
    double noise;      ///< indentation from which a closed contact is watched; 0 if it is from the start
  };
  std::vector<Body> body;
  std::vector<Contact> contacts;
};

/// A phase of bodies on a line, each with a contact to the next, under constant outside accelerations: where
/// its quantities stand in the state.
struct SerialPhase {
  struct Body {
    Index velocity;
    double inverse_mass;
    double acceleration;
  };
  enum class Role : signed char {
    open,      ///< carries no force; closes where its gap is −level
    closed,    ///< carries force
    touching,  ///< carries force; touched at rest before, its guards are not watched yet
    slack      ///< indented without force
  };
  /// Contact j joins bodies j and j+1; f = δ^{n−1} (k δ + c δ̇).
  struct Contact {
    Index gap;
    Index work;        ///< ∫ f δ̇ dt, or −1
    Index impulse;     ///< ∫ f dt, or −1
    Index guard;       ///< of the gap
    Index load_guard;  ///< of k δ + c δ̇, or −1
    double stiffness, damping, exponent;
    double length;   ///< natural indentation
    double shallow;  ///< indentation that cannot be told from rounding
    double level = 0;
    Role role = Role::open;
  };
  std::vector<Body> body;
  std::vector<Contact> contact;
  double speed = 1;  ///< natural relative speed
};

/// A field of one mode, with everything dimensionless. Sizes and pattern never change; field, crossings and
/// time scale belong to the present mode. Implemented by the models.
class Problem {
 public:
  virtual ~Problem() = default;

  virtual Index size() const = 0;
  virtual void derivative(ConstState x, State dx) const = 0;

  virtual Index guard_count() const = 0;
  virtual void guards(ConstState x, State values) const = 0;
  /// Time derivatives of the guards, given dx = f(x).
  virtual void guard_rates(ConstState x, ConstState dx, State rates) const = 0;
  /// One crossing per guard.
  virtual std::span<const Crossing> crossings() const = 0;

  /// Natural size of each component: an error of accuracy × magnitude is what the user allows.
  virtual std::span<const double> magnitudes() const = 0;
  /// Shortest natural time of what is active.
  virtual double time_scale() const = 0;

  /// Places of the Jacobian in any mode, and their values in this one, in the same order.
  virtual std::vector<Entry> pattern() const = 0;
  virtual void jacobian(ConstState x, State values) const = 0;
  /// Largest damping ratio c/√(k m) of the active contacts: what makes a phase stiff.
  virtual double damping_ratio() const = 0;

  /// True if no force acts but constant accelerations: then x(t) = x + t f(x) + t²/2 f'(x) f(x) exactly, and
  /// the guards are linear in x.
  virtual bool is_ballistic() const = 0;
  /// f'(x) f(x), asked of ballistic modes only.
  virtual void second_derivative(ConstState x, State ddx) const = 0;

  /// The present mode as one pair, if it is one whose contact has a closed form.
  virtual std::optional<PairPhase> pair() const { return std::nullopt; }

  /// Number of contacts that carry force in the present mode if all of them are linear and nothing else acts
  /// on the bodies, else 0; and the mode as such, filled in where it is asked.
  virtual Index linear_contacts() const { return 0; }
  virtual void linear(LinearPhase&) const {}

  /// The present mode as a series of bodies, if it is one; follows every change of the mode.
  virtual const SerialPhase* serial() const { return nullptr; }

  /// Told after every accepted step: a guard that starts at zero is watched only once it has left it, and
  /// what has sunk into rounding noise is no longer worth following.
  virtual Accepted accept(ConstState x) = 0;

  /// Name of a component for messages, such as "velocity 3".
  virtual std::string component(Index index) const = 0;
};

}  // namespace mariotte::flow
