// The smooth field of a microbody while its mode stays as it is, and the guards that end it.
#pragma once
#include <vector>

#include "mariotte/flow/problem.hpp"
#include "mariotte/model/microbody/microbody_mechanics.hpp"

namespace mariotte::model {

/// Guards of tip i are 5 i + one of these.
enum class TipGuard : unsigned char { gap, force, slip, cone, turn_back };
inline constexpr Index guards_per_tip = 5;

/// Place of a tip's guard among those of the phase.
inline Index guard_index(Index tip, TipGuard guard) {
  return guards_per_tip * tip + static_cast<Index>(guard);
}

/// Behind those of all tips: the mass centre rises so high that no tip can reach the plane.
inline Index escape_guard(Index tips) {
  return guards_per_tip * tips;
}
/// The last: a body that cannot leave any more has come to rest in the wells of its tips.
inline Index rest_guard(Index tips) {
  return guards_per_tip * tips + 1;
}

/// What a run watches beside what it must.
struct WatchedSigns {
  bool force_signs =
      true;  ///< F_n = 0 even where nothing changes there: without friction, or sticking freely
};

/// A microbody bound to a mode; `bind` moves it on to the next.
class MicrobodyPhase final : public flow::Problem {
 public:
  MicrobodyPhase(const DimensionlessMicrobody& body, const MicrobodyLayout& layout, double accuracy,
                 WatchedSigns watched);

  void bind(const MicrobodyMode& mode);
  const MicrobodyMode& mode() const { return mode_; }
  const Mechanics& mechanics() const { return mechanics_; }
  /// Positive until the energy is below the barrier of adhesion and no tip moves along the normal, nor will
  /// soon, by more than counts as rest; from then on the body is captured.
  double unrest(ConstState x) const;

  Index size() const override { return layout_.size; }
  void derivative(ConstState x, State dx) const override { mechanics_.derivative(x, mode_, dx); }
  Index guard_count() const override { return rest_guard(layout_.tips) + 1; }
  void guards(ConstState x, State values) const override;
  void guard_rates(ConstState x, ConstState dx, State rates) const override;
  std::span<const flow::Crossing> crossings() const override { return crossings_; }
  std::span<const double> magnitudes() const override { return magnitudes_; }
  double swiftness(ConstState x) const override;
  double time_scale() const override { return time_scale_; }
  std::vector<flow::Entry> pattern() const override { return mechanics_.pattern(); }
  void jacobian(ConstState x, State values) const override { mechanics_.jacobian(x, mode_, values); }
  double damping_group() const override;
  double least_load(double accuracy) const override;
  bool is_ballistic() const override { return closed_ == 0 && body_.symmetric; }
  void second_derivative(ConstState x, State ddx) const override;
  const flow::TipPhase* tip() const override { return series_ ? &tip_ : nullptr; }
  const flow::FreePhase* free_body() const override { return is_ballistic() ? &free_ : nullptr; }
  flow::Accepted accept(ConstState x) override;
  std::string component(Index index) const override { return component_name(layout_, index); }

 private:
  double slip_margin(const TipMode& mode) const;
  double own_direction() const;
  bool slip_turns() const;
  double normal_damping_group() const;
  double signed_pressure(const TipMotion& tip, Index i) const;
  double pressure_error(const TipMotion& tip, Index i) const;
  double guard(ConstState x, const TipForces& forces, Index i) const;
  double imbalance(ConstState x, double speed) const;
  void watch(Index tip);
  void bind_series();
  bool is_known(const TipMode& tip) const;
  void bind_guards(Index i);
  bool turn_with_slip(TipMode& tip, const Vector3& slip) const;
  flow::Crossing& crossing(Index tip, TipGuard guard) { return crossings_[guard_index(tip, guard)]; }

  const DimensionlessMicrobody& body_;
  const MicrobodyLayout& layout_;
  double accuracy_;
  Mechanics mechanics_;
  WatchedSigns watched_;
  MicrobodyMode mode_;
  Index closed_ = 0;
  bool series_ = false;
  double time_scale_ = 1;
  std::vector<double> magnitudes_;
  std::vector<flow::Crossing> crossings_;
  std::vector<bool> waiting_;          ///< starts at zero and is watched once it has left it
  std::array<bool, 2> doubtful_ = {};  ///< force of a tip that has not left zero by more than its error
  flow::TipPhase tip_;
  flow::FreePhase free_;
};

}  // namespace mariotte::model
