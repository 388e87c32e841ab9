// What the series of balls with several contacts at once are told: numbers, guards, and how their motion
// stands in the state.
#pragma once
#include <array>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/cluster/cluster_field.hpp"

namespace mariotte::flow {

/// A ball that contacts move.
struct ClusterBall {
  double ease = 0, turn_ease = 0;               ///< 1/m and 1/J
  double velocity_weight = 0, spin_weight = 0;  ///< 1/size: what errors are relative to
  double velocity_x = 0, velocity_y = 0, spin = 0;
};

/// Of a contact that does nothing.
constexpr std::array<double, ClusterField::parameters> idle_contact() {
  std::array<double, ClusterField::parameters> p = {};
  p[ClusterField::radii] = 1;
  return p;
}

/// A contact that is closed; what `ClusterField` names.
struct ClusterLink {
  int a = -1, b = 0;      ///< balls; a = −1: a plane
  bool begins = false;    ///< δ is 0 now, and grows
  bool has_root = false;  ///< √δ is what its force is made of
  double radius_a = 0, radius_b = 0, share_a = 0, share_b = 0;
  std::array<double, ClusterField::parameters> parameter = idle_contact();
  std::array<double, ClusterField::rows> weight = {};  ///< 1/size
  std::array<double, ClusterField::states> start = {};
  // Guards.
  Index open = -1, turn = -1, friction = -1;
  bool sticks = false, unloading = false;
  double sign = 1;         ///< of slip
  double rate_noise = 0;   ///< of approach and slip
  double cap = 0;          ///< μ: what sticks slips where friction exceeds μ f_n …
  double cap_noise = 0;    ///< … by this share of what that is at first …
  double force_noise = 0;  ///< … and this
};

/// One that is open, but may close soon.
struct ClusterGap {
  int a = -1, b = 0;
  Index close = -1, part = -1;  ///< guards; where it touches at rest, a little beyond
  double touch_depth = 0;
  double gap = 0;  ///< to where it closes, which is its dent if it has one
  double normal_x = 0, normal_y = 0;
  double bend = 0;                        ///< 1/(2 distance of the centres); 0 of a plane
  double velocity_x = 0, velocity_y = 0;  ///< of a plane

  /// (|d|² − (R − offset)²)/2|d|, which has the sign of gap + offset; of a plane just that.
  double beyond(double offset) const { return (gap + offset) * (1 - bend * (gap + offset)); }
};

/// All of them.
struct Cluster {
  std::vector<ClusterBall> ball;
  std::vector<ClusterLink> link;
  std::vector<ClusterGap> gap;
  double pull_x = 0, pull_y = 0;
};

/// What has become of a closed contact and of a ball.
struct LinkMotion {
  double depth, spring, normal, tangential, work;
};
struct BallMove {
  double shift_x, shift_y, turn;  ///< since the start
  double velocity_x, velocity_y, spin;
};
struct ClusterMotion {
  double time;
  std::vector<BallMove> ball;
  std::vector<LinkMotion> link;
};

/// A phase of balls in the plane in which any number of contacts is closed.
class ClusterPhase {
 public:
  virtual ~ClusterPhase() = default;
  /// Contacts that are not far from closing at x, or `all`, belong to the cluster from now on.
  virtual void gather(ConstState x, bool all) = 0;
  /// The cluster where it is at x; a contact that closes when the phase begins, which x `may_close`, begins
  /// at the depth 0.
  virtual const Cluster& load(ConstState x, bool may_close) = 0;
  /// Whether no contact that was left out can close within a time from x on, in which no ball of the cluster
  /// goes farther than its `reach`.
  virtual bool stays_far(ConstState x, double time, ConstState reach) = 0;
  /// The guard of a body that has gone so far that near contacts should be listed anew; −1 if none has.
  virtual Index stray(ConstState x) const = 0;
  /// The state where the motion that began at `from` has come to; everything else flies.
  virtual void move(ConstState from, const ClusterMotion& motion, State x) const = 0;
};

}  // namespace mariotte::flow
