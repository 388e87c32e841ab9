// A mode of bodies in which one Hertz contact of balls in the plane is closed, as compiled fields follow it.
#pragma once
#include "mariotte/flow/balls/ball_phase.hpp"
#include "mariotte/model/bodies/bodies_motion.hpp"

namespace mariotte::model {

/// Of a phase: it has the setting, and the guards.
class BodiesBalls final : public flow::BallPhase {
 public:
  explicit BodiesBalls(const BodiesSetting<2>& setting) : setting_(setting) {}

  /// True if a mode is of this kind.
  bool admits(const BodiesMode& mode) const;
  /// Follow it; `first_guard` is the first of its slot.
  void bind(const BodiesMode& mode, const BodiesLayout<2>& layout, std::span<const double> magnitude,
            Index first_guard);

  const flow::BallContact& contact() const override { return contact_; }
  Motion begin(ConstState x, bool may_close) override;
  void move(ConstState from, const Motion& motion, State x) const override;
  bool is_clear(ConstState x, double time, double speed) const override;

 private:
  void set_guards(const ClosedContact& closed, Index first);
  void set_bodies();
  void set_friction(double sign);
  void set_weights(std::span<const double> magnitude);
  void move_body(Index body, double share, const Vec<double, 2>& gone, const Vec<double, 2>& relative,
                 const Motion& motion, State x) const;
  void move_slot(const Motion& motion, State x) const;
  double rescaled(const Motion& motion) const;
  double stored(const Motion& motion) const;
  double reach(ConstState x, Index body, double time, double speed) const;

  const BodiesSetting<2>& setting_;
  const BodiesMode* mode_ = nullptr;
  BodiesLayout<2> layout_;
  const SettingContact<2>* one_ = nullptr;
  Index slot_ = 0, a_ = -1, b_ = -1;  ///< bodies; a = −1: a plane
  double share_a_ = 0, share_b_ = 1;  ///< of their relative motion
  flow::BallContact contact_;
  Motion start_ = {};
  Vec<double, 2> normal_, common_;  ///< where the motion began; common velocity
  mutable std::vector<double> reach_;
};

}  // namespace mariotte::model
