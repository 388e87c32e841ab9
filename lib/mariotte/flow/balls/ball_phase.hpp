// What the series of one contact of balls in the plane are told: numbers, and how its motion stands in the
// state.
#pragma once
#include <array>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/balls/ball_field.hpp"

namespace mariotte::flow {

/// One closed contact; what `BallMotion` names.
struct BallContact {
  Grip grip = Grip::none;
  bool pair = false;  ///< of two balls
  bool unloading = false;
  bool is_alone = false;  ///< there are no other contacts
  std::array<double, BallMotion::parameters> parameter = {};
  std::array<double, BallMotion::states> weight = {};        ///< 1/size of each: what errors are relative to
  Index open = -1, friction = -1, turn = -1;                 ///< guards
  double rate_noise = 0;                                     ///< of approach and slip
  double force_share = 0, force_noise = 0, faint_force = 0;  ///< by which friction may exceed its cap
};

/// A phase of bodies in which one contact of balls is closed.
class BallPhase {
 public:
  using Motion = std::array<double, BallMotion::states>;
  virtual ~BallPhase() = default;
  virtual const BallContact& contact() const = 0;
  /// The motion at x, from where `move` goes on; time and integrals begin at 0. A contact that closes when
  /// the phase begins, which x `may_close`, begins at the depth 0.
  virtual Motion begin(ConstState x, bool may_close) = 0;
  /// The state where the motion that began at `from` has come to `motion`; everything else flies.
  virtual void move(ConstState from, const Motion& motion, State x) const = 0;
  /// Whether no other contact can close within a time from x on, while the velocity of b on a is no larger
  /// than `speed`.
  virtual bool is_clear(ConstState x, double time, double speed) const = 0;
};

}  // namespace mariotte::flow
