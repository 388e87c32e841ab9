// What a flow by series needs of a phase whose field is recorded when the phase begins.
#pragma once
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/balls/ball_phase.hpp"
#include "mariotte/flow/cluster/cluster_phase.hpp"
#include "mariotte/series/tape_series.hpp"

namespace mariotte::flow {

/// A guard on a tape; times `sign` it fires where it falls through zero.
struct RecordedGuard {
  Index guard;
  int place;
  double sign;
};

/// A closed contact: its indentation on the tape, that until it lets go, what has the root of that if force
/// or stiffness do, and the guard that opens it.
struct RecordedContact {
  int depth, left;
  int root;  ///< or −1
  Index open;
  int normal, friction;  ///< forces
  bool is_square;        ///< of friction
  bool begins;           ///< `left` is 0 now, and grows
  double negligible;     ///< indentation from which what is left until it opens is below the accuracy
};

/// Field and guards of one phase on a tape.
struct Recording {
  series::Tape tape;
  std::vector<series::TapeState> state;
  std::vector<Index> component;  ///< of the problem's state, for each of these
  std::vector<RecordedGuard> guard;
  std::vector<RecordedContact> contact;
  bool is_partial = false;  ///< guards that are far from firing have been left out
};

/// A phase that can be recorded.
class RecordedPhase {
 public:
  virtual ~RecordedPhase() = default;
  /// Record field and guards of the present mode at x, where events within `accuracy` are one: `all` guards,
  /// or those that are not far from firing.
  virtual void record(ConstState x, double accuracy, bool all, Recording& recording) const = 0;
  /// Whether no guard that was left out can fire within a time from x on, while no component that is recorded
  /// moves farther than it is said to.
  virtual bool stays_far(ConstState x, double time, ConstState moves) const = 0;
  /// Components that are not recorded move freely: their values after time t.
  virtual void fly_others(ConstState x, double t, State result) const = 0;
  /// The present mode if its field is compiled: of one contact, and of any number.
  virtual BallPhase* balls() const { return nullptr; }
  virtual ClusterPhase* cluster() const { return nullptr; }
};

}  // namespace mariotte::flow
