// Balls that rest or fly freely: known in closed form from when they were last touched, and never integrated.
#pragma once
#include <vector>

#include "mariotte/core/instant.hpp"
#include "mariotte/model/chain/chain_system.hpp"
#include "mariotte/model/islands/repetition.hpp"

namespace mariotte::model {

/// The whole state of a chain, each part of it as it was at a time of its own.
class FreeBalls {
 public:
  FreeBalls(const DimensionlessChain& chain, const ChainLayout& layout, ConstState start);

  Index contacts() const { return layout_.contacts(); }
  contact::ContactSet& modes() { return mode_; }
  const contact::ContactSet& modes() const { return mode_; }
  /// Each part as of its own time.
  ChainState state() const { return {{chain_, layout_}, x_, &mode_}; }

  /// Of a free ball, and of the gap between two, at t.
  double velocity(Index i, Instant t) const;
  double gap(Index j, Instant t) const;
  /// v_j − v_{j+1} of two free balls.
  double approach(Index j, Instant t) const;
  /// Difference of the accelerations of balls j and j+1: not zero beside a wall under gravity only.
  double drive(Index j) const { return chain_.gravity[j + 1] - chain_.gravity[j]; }
  double gap(Index j) const { return x_[layout_.gap[j]]; }

  /// Move the gap of contact j between free balls on to t. A contact closing so slowly that the approach may
  /// be rounding gets no deeper than such an approach can reach.
  void move_contact(Index j, Instant t);
  /// Move the velocity of ball i on to t.
  void move_ball(Index i, Instant t);
  /// Contact j touches: its gap stands where it closes.
  void touch(Index j) { x_[layout_.gap[j]] = 0 - level(j); }

  /// When the gap of contact j, moved on to t, falls to where the contact closes; infinite if it never does,
  /// or so slowly that the approach may be rounding.
  Instant meeting(Index j, Instant t) const;
  /// That instant cannot be told from t.
  bool is_due(Index j, Instant t, double accuracy) const;
  /// Contact j touches at rest.
  bool rests(Index j, Instant t) const;

  /// State of balls first to last, all moved on to one time, in the layout of a slice.
  State slice(Index first, Index last);
  /// The slice's state now belongs to t.
  void stamp(Index first, Index last, Instant t);

  /// A wave among undamped contacts without walls has moved on from where it is at t. What it passes rests
  /// afterwards.
  void repeat(const Repetition& of, Instant t);

  /// The whole state at t.
  std::vector<double> take(Instant t);
  /// What a copy takes.
  std::size_t bytes() const {
    return x_.size() * sizeof(double) + mode_.size() +
           (contact_time_.size() + ball_time_.size()) * sizeof(Instant);
  }

 private:
  double level(Index j) const {
    return model::level(mode_[j], chain_.law[j], memory_of(mode_, j), chain_.noise_depth[j]);
  }
  /// Gap less that at which the contact closes.
  double clearance(Index j) const { return state().clearance(j); }

  const DimensionlessChain& chain_;
  const ChainLayout& layout_;
  std::vector<double> x_;
  contact::ContactSet mode_;
  std::vector<Instant> contact_time_;
  std::vector<Instant> ball_time_;  ///< empty without gravity: velocities are constant
};

}  // namespace mariotte::model
