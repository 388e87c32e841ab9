// Back through one piece of a motion, by collocation in its Gauss points.
//
// In the points λ_v and λ_g are what they are at the end less the integrals of their rates up to there.
// Sweeps Z ← (end) − ∫ (rates of Z) converge fast: a piece is a small part of a contact's period.
#pragma once
#include <span>
#include <vector>

#include "mariotte/impact/sensitivity/adjoint/contact_turn.hpp"
#include "mariotte/impact/sensitivity/adjoint/motion_record.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

namespace mariotte::impact {

/// Slopes of Σ w_i v_i by the numbers of a chain; by masses of walls zero, nan where there is none.
struct RowSlopes {
  std::vector<double> mass, velocity;                     ///< by ball; `velocity` at the start
  std::vector<double> gap, stiffness, damping, exponent;  ///< by contact; `gap` at the start
};

/// Takes the pieces of a motion from the last to the first.
class PieceSweep {
 public:
  /// `slopes` are those at the time reached: `velocity` is λ_v and `gap` λ_g. All must outlive this.
  PieceSweep(const model::DimensionlessChain& chain, const MotionRecord& motion, RowSlopes& slopes);

  /// The piece before, which is one of this stretch.
  void pass(const MotionRecord::Stretch& stretch);
  const contact::PowerLaw& law(Index j) const { return *power_law(chain_.law[j]); }
  /// λ · push of contact j, where λ_v is `velocity`.
  template <class Velocity>
  double turning(Index j, Velocity&& velocity) const {
    return chain_.inverse_mass[j + 1] * velocity(j + 1) - chain_.inverse_mass[j] * velocity(j);
  }

 private:
  /// A contact in a piece: its force and the slopes of that, and how λ_g and λ_v move, all times dt/du.
  struct Push {
    Index number;
    int rise, fall;
    Nodes depth, rate;
    Nodes force, by_depth, by_rate;
    Nodes mu, gap_rate, velocity_rate;
  };

  std::span<Push> acting() { return std::span(push_).first(acting_); }
  void take(Push& own);
  void prepare(const MotionRecord::Stretch& stretch);
  void find_balls();
  void solve();
  double take_next();
  void turn(Push& own, double held);
  void finish(const MotionRecord::Stretch& stretch);
  void add_slopes(const Push& own);

  const model::DimensionlessChain& chain_;
  RowSlopes& slopes_;
  std::vector<MotionRecord::Piece>::const_iterator piece_;
  std::vector<MotionRecord::Contact>::const_iterator contact_;
  std::vector<Nodes>::const_iterator rate_;
  UntilEnd until_end_;
  TurnContact turn_contact_ = choose_turn();
  std::vector<Push> push_;
  std::size_t acting_ = 0;                  ///< the first of them; the others are shallow
  std::vector<Index> balls_;                ///< of all of them
  std::vector<Nodes> base_, value_, next_;  ///< λ_v of a ball: without any push, now, and after this sweep
  std::vector<double> drift_;               ///< rate of λ_v that contacts which do not push give
  std::vector<char> pushes_;
};

}  // namespace mariotte::impact
