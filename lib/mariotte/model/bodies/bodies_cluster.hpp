// A mode of bodies in which contacts of balls in the plane are closed, as compiled fields follow it.
#pragma once
#include "mariotte/flow/cluster/cluster_phase.hpp"
#include "mariotte/model/bodies/bodies_motion.hpp"

namespace mariotte::model {

/// Where guards stand in a phase: those of slots come first.
struct BodiesGuards {
  Index gaps = 0, partings = 0, strays = 0;
};

/// Of a phase: it has the setting, and the guards.
class BodiesCluster final : public flow::ClusterPhase {
 public:
  explicit BodiesCluster(const BodiesSetting<2>& setting);

  /// True if a mode is of this kind.
  bool admits(const BodiesMode& mode) const;
  /// Follow it.
  void bind(const BodiesMode& mode, const BodiesLayout<2>& layout, std::span<const double> magnitude,
            const BodiesGuards& guards);

  void gather(ConstState x, bool all) override;
  const flow::Cluster& load(ConstState x, bool may_close) override;
  bool stays_far(ConstState x, double time, ConstState reach) override;
  Index stray(ConstState x) const override;
  void move(ConstState from, const flow::ClusterMotion& motion, State x) const override;

 private:
  void set_sides(const SettingContact<2>& c, flow::ClusterLink& link);
  int ball_of(Index sphere);
  void add_closed(const ClosedContact& closed);
  void add_open(Index contact, Index place);
  void set_friction(const ClosedContact& closed, flow::ClusterLink& link) const;
  void set_stick(const ClosedContact& closed, flow::ClusterLink& link) const;
  void set_slip(const ClosedContact& closed, flow::ClusterLink& link) const;
  void set_weights(const ClosedContact& closed, flow::ClusterLink& link) const;
  void load_link(const ClosedContact& closed, ConstState x, bool may_close, flow::ClusterLink& link) const;
  void load_gap(Index contact, ConstState x, flow::ClusterGap& gap) const;
  double gone(ConstState x, Index body) const;
  void move_ball(Index body, const flow::BallMove& ball, State x) const;
  void move_slot(const ClosedContact& closed, const flow::ClusterLink& link, const flow::LinkMotion& motion,
                 State x) const;
  double rescaled(const ClosedContact& closed, const flow::ClusterLink& link,
                  const flow::LinkMotion& motion) const;

  const BodiesSetting<2>& setting_;
  bool are_balls_ = true;
  const BodiesMode* mode_ = nullptr;
  BodiesLayout<2> layout_;
  std::span<const double> magnitude_;
  BodiesGuards guards_;
  flow::Cluster cluster_;
  std::vector<Index> open_;  ///< contact of each gap
  std::vector<Index> body_;  ///< of each ball
  std::vector<int> ball_;    ///< of each body; −1: it is none of them
  std::vector<Index> far_;   ///< contacts that are left out
  std::vector<double> reach_;
};

}  // namespace mariotte::model
