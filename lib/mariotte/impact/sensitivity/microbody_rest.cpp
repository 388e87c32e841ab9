#include "mariotte/impact/sensitivity/microbody_rest.hpp"

namespace mariotte::impact {
namespace {

using model::Mechanics;
using model::MicrobodySystem;
using model::TipContact;

model::TipMode first_tip(const MicrobodySystem& system, ConstState x0) {
  model::MicrobodyMode mode;
  std::vector<model::MicrobodyChange> ignored;
  system.mode_at(x0, mode, ignored);
  return mode.tip[0];
}

/// What impulses in the plane do to a tip.
class Pushed {
 public:
  Pushed(const MicrobodySystem& system, ConstState x)
      : system_(system), x_(x), lever_(mechanics(system.body()).tip(x, 0).lever) {
    const Vector3 still = mechanics(system.body()).tip(x, 0).slip;
    for (const bool along_e3 : {false, true}) {
      std::vector<double> moved(x.begin(), x.end());
      add({0, along_e3 ? 0.0 : 1.0, along_e3 ? 1.0 : 0.0}, moved);
      (along_e3 ? by_e3_ : by_e2_) = mechanics(system.body()).tip(moved, 0).slip - still;
    }
  }

  /// Adds an impulse of the plane to velocity and angular momentum.
  void add(const Vector3& impulse, State x) const {
    const auto& place = system_.layout().place;
    put<double>(x, place.velocity,
                vector_at<double>(x, place.velocity) + (1 / system_.body().body.mass) * impulse);
    put<double>(x, place.momentum, vector_at<double>(x, place.momentum) + cross(lever_, impulse));
  }
  /// The one that changes the slip by so much.
  Vector3 impulse(const Vector3& change) const {
    const double size = by_e2_.e2 * by_e3_.e3 - by_e3_.e2 * by_e2_.e3;
    return {0, (by_e3_.e3 * change.e2 - by_e3_.e2 * change.e3) / size,
            (by_e2_.e2 * change.e3 - by_e2_.e3 * change.e2) / size};
  }
  /// Slopes of the slip by a parameter, where those of the state are these.
  Vector3 slip(const ShiftedBodies& shifted, ConstState slopes) const {
    Vector3 sum;
    std::vector<double> moved(x_.size());
    for (std::size_t k = 0; k < stencil.size(); ++k) {
      for (std::size_t r = 0; r < moved.size(); ++r)
        moved[r] = x_[r] + stencil[k].offset * shifted.step * slopes[r];
      sum = sum + (stencil[k].weight / shifted.step) * mechanics(shifted.at[k]).tip(moved, 0).slip;
    }
    return sum;
  }

 private:
  Mechanics mechanics(const model::DimensionlessMicrobody& body) const { return {body, system_.layout()}; }

  const MicrobodySystem& system_;
  ConstState x_;
  Vector3 lever_, by_e2_, by_e3_;
};

}  // namespace

void rest_at_start(const MicrobodySystem& system, const std::vector<ShiftedBodies>& shifted, ConstState x0,
                   SlopeMatrix& start) {
  const bool sticks = first_tip(system, x0).contact == TipContact::sticking;
  if (!sticks || system.body().friction.coefficient == 0) return;
  const Pushed pushed(system, x0);
  for (Index c = 0; c < start.columns; ++c) {
    const auto slip = pushed.slip(shifted[static_cast<std::size_t>(c)], start.column(c));
    pushed.add(pushed.impulse(-1 * slip), start.column(c));
  }
}

std::vector<bool> slips_at_start(const MicrobodySystem& system, const std::vector<ShiftedBodies>& shifted,
                                 ConstState x0, const SlopeMatrix& start) {
  constexpr double rounding = 1e-9;
  std::vector<bool> moved(shifted.size(), false);
  if (!first_tip(system, x0).at_touch) return moved;
  const Pushed pushed(system, x0);
  for (std::size_t c = 0; c < moved.size(); ++c) {
    const double slip = shifted[c].step * norm(pushed.slip(shifted[c], start.column(static_cast<Index>(c))));
    moved[c] = slip > rounding * system.body().speed;
  }
  return moved;
}

}  // namespace mariotte::impact
