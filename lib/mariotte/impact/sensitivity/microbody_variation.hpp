// How the field and the guards of a microbody move with its parameters, at a fixed state: by the stencil,
// from the bodies at its points. The field is the one of a body that may move in any way.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "mariotte/flow/flow.hpp"
#include "mariotte/impact/sensitivity/near_rest.hpp"
#include "mariotte/impact/sensitivity/slope_matrix.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"
#include "mariotte/model/microbody/microbody_system.hpp"

namespace mariotte::impact {

/// One body per point of the stencil, in the units of the base.
struct ShiftedBodies {
  double step;
  std::array<model::DimensionlessMicrobody, stencil.size()> at;
};

/// Where the tip that touched first has come off first.
struct FirstOpening {
  double time;
  std::vector<double> state;
  SlopeMatrix slopes;               ///< of the state at that instant, which moves
  std::vector<double> time_slopes;  ///< of the instant, by parameter
};

class MicrobodyVariation {
 public:
  /// One event: modes on both sides of it, the state and its rates and slopes before it, and slopes of times.
  struct Passage {
    const std::vector<Index>& guard;  ///< that tell when it happens
    const model::MicrobodyMode &before, &after;
    ConstState x, rate;
    const SlopeMatrix& slopes;
    const std::vector<std::vector<double>>& time;  ///< of each guard by the clock of the slopes, by parameter
    const std::vector<double>& clock;              ///< of that clock
    double now;
  };

  MicrobodyVariation(const model::MicrobodySystem& system, const std::vector<ShiftedBodies>& shifted);

  Index columns() const { return std::ssize(shifted_); }
  const std::vector<double>& natural_slopes() const { return natural_; }
  /// Where the body is, which does not tell how large slopes are.
  std::vector<Index> places() const;
  void jacobian(const flow::Problem& problem, ConstState x, const model::MicrobodyMode& mode,
                State values) const;
  void source(ConstState x, const model::MicrobodyMode& mode, SlopeMatrix& b) const;
  /// By how much errors of both exceed rounding: the direction of a slip is known as well as the slip.
  double cancellation(ConstState x, const model::MicrobodyMode& mode) const;
  double guard_rate(const flow::Problem& problem, Index i, ConstState x, ConstState dx,
                    const model::MicrobodyMode& mode) const;
  void guard_slopes(Index i, ConstState x, const model::MicrobodyMode& mode, std::span<double> slopes) const;
  double crossing_speed(Index i, double rate, const model::MicrobodyMode& mode) const;
  double natural_time(Index) const { return base_.time; }
  /// A body comes to rest where its motion is no more than the accuracy.
  bool has_time(Index i, const model::MicrobodyMode&) const {
    return i != model::rest_guard(system_.layout().tips);
  }
  std::string name(Index i, const model::MicrobodyMode&) const {
    return "tip " + std::to_string(i / model::guards_per_tip + 1);
  }

  /// The first tip touches at the start whatever the parameters are.
  std::vector<Index> guards_at_start(const model::MicrobodyMode&, ConstState) const { return {}; }
  void open_at_start(model::MicrobodyMode&, Index) const {}
  bool has_root(Index i, const model::MicrobodyMode&) const {
    return i < model::escape_guard(system_.layout().tips) &&
           static_cast<model::TipGuard>(i % model::guards_per_tip) == model::TipGuard::gap;
  }
  void meet(Index i, const model::MicrobodyMode& mode, State x) const;
  /// Guards that tell when an event happens, of those that have fired: a tip that lets go does so where its
  /// gap says, though a guard of its friction may have fired within rounding of that.
  std::vector<Index> telling(const std::vector<Index>& fired, const model::MicrobodyMode& before,
                             const model::MicrobodyMode& after) const;
  /// Whether its tip has touched by guard i.
  bool closes(Index i, const model::MicrobodyMode& before, const model::MicrobodyMode& after) const {
    if (i >= model::escape_guard(system_.layout().tips)) return false;
    const auto tip = static_cast<std::size_t>(i / model::guards_per_tip);
    return before.tip[tip].contact == model::TipContact::clear &&
           after.tip[tip].contact != model::TipContact::clear;
  }
  /// Its forces rise like δ^{1/2} at least.
  double lost_at_onset(Index) const { return 0; }
  /// Whether no tip touches.
  bool is_free(const model::MicrobodyMode& mode) const {
    for (Index tip = 0; tip < system_.layout().tips; ++tip)
      if (mode.tip[static_cast<std::size_t>(tip)].contact != model::TipContact::clear) return false;
    return true;
  }
  void settle(Index i, const model::MicrobodyMode& before, State x) const { meet(i, before, x); }
  /// Notices slips in space that start from rest.
  void remember(Index i, const model::MicrobodyMode& before, const model::MicrobodyMode& after,
                const SlopeMatrix& slopes, ConstState rate, std::span<const double> time);
  /// A slip that comes to rest does so along every direction, whatever parameters are: none of its slope is
  /// left.
  void come_to_rest(const model::MicrobodyMode& before, const model::MicrobodyMode& after, ConstState x,
                    SlopeMatrix& slopes) const;
  /// Keeps the end of the first contact.
  void keep_opening(const Passage& event);
  const std::optional<FirstOpening>& opening() const { return opening_; }
  bool slips_from_rest() const { return slips_from_rest_; }
  /// Notices slips in space that come near rest and go on.
  void see(const flow::Step& step, const model::MicrobodyMode& mode) const;
  /// How many times the error of a state slopes may have where they do.
  double turning_loss() const { return base_.speed / near_rest_.closest(); }

 private:
  model::Mechanics mechanics(const model::DimensionlessMicrobody& body) const;
  /// A tip that slides with friction.
  struct Slide {
    Index tip;
    double slip;        ///< its size; infinite where its direction is given
    Vector3 direction;  ///< of the slip
    double force;       ///< normal
  };
  std::vector<Slide> slides(ConstState x, const model::MicrobodyMode& mode) const;
  Vector3 slip_slope(Index tip, ConstState x, std::span<const double> slopes, Index c) const;
  std::array<model::MicrobodyMode, stencil.size()> modes_at(const model::MicrobodyMode& mode,
                                                            const std::vector<Slide>& slides, ConstState x,
                                                            Index c) const;
  model::MicrobodyMode sliding_freely(model::MicrobodyMode mode, ConstState x) const;

  const model::MicrobodySystem& system_;
  const std::vector<ShiftedBodies>& shifted_;
  model::DimensionlessMicrobody base_;
  std::vector<double> natural_;
  std::optional<FirstOpening> opening_;
  bool slips_from_rest_ = false;
  mutable NearRest near_rest_;
};

}  // namespace mariotte::impact
