// One step of the Taylor flow: which series, how far, and whether a guard fires within it.
#pragma once
#include <array>
#include <memory>
#include <optional>

#include "mariotte/flow/taylor/taylor_piece.hpp"

namespace mariotte::flow::taylor {

/// What makes a step accurate enough.
struct Precision {
  double tolerance = 0;  ///< of one step
  int order = 0;
  bool has_slopes = false;  ///< of whoever looks on
};

/// For a wanted error at the end of the run.
Precision precision(double accuracy);

/// The guard that ends a step.
struct Fall {
  Index guard = -1;  ///< −1: none
  int lane = -1;
  double place = infinity;
};

/// Takes one step after the other until a guard fires.
class Stepper {
 public:
  /// Start at x, the whole state at `time`.
  void begin(const Problem& problem, State x, double time, const Precision& precision);
  /// About the length of the steps before, or a guess.
  double stride = 0;

  /// The longest piece within the tolerance that wakes no contact too late and ends after `time` at the
  /// latest. `first` allows the series of contacts that start undeformed.
  Piece next(bool first, double time);
  /// The first guard that fires within the piece; proven. The piece ends there, where that guard is exactly
  /// at its level, or earlier, where a contact turns at δ = 0 or wakes.
  Fall first_fall(Piece& piece);
  /// Another guard may fall as well within `time` of the end of the step, by its tangent.
  bool may_fall_soon(const Fall& fall, double time) const;
  /// What the piece says at its end.
  const Values& values() const { return values_; }
  /// A contact whose force is left out is deeper at the end of the piece than it may be: a fault.
  bool is_late() const;
  /// Move the window to the end of the piece.
  void advance(const Piece& piece);

  Window window;

 private:
  bool is_struck(int lane) const;
  bool starts();
  bool finds_struck();
  bool finds_pressed();
  std::optional<Piece> start_piece();
  Piece plan_piece();
  int choose_clock(double near) const;
  bool has_strong_roots() const;
  bool counts_onsets() const;
  int narrowest() const;
  Piece series_piece();
  void land(Piece& piece);
  void end_beyond_noise(Piece& piece, int lane) const;
  void end_beyond_knots(Piece& piece, int lane) const;
  void end_at_turn(Piece& piece, int lane);
  void end_at(Fall& fall, Piece& piece);
  void stand_at(const Fall& fall, const Piece& piece);
  Fall search_guards(Piece& piece);
  void shorten(Piece& piece, double place);
  double reach(const Piece& piece) const;
  double within_roots(const Piece& piece, double end) const;
  void doze(int lane);
  void listen(int lane);
  /// A touching contact whose force is left out, and which is watched for the depth at which it would be
  /// late.
  bool dozes(int lane) const {
    return window.lanes.side[lane] < 0 && window.contact(lane).role == Role::touching;
  }
  /// A contact with leeway is beyond its level.
  bool has_faded(int lane) const {
    const auto& l = window.lanes;
    return l.has_leeway() && l.leeway[lane] > 0 && !(l.active[lane] > 0) &&
           values_.indentation[lane] < -l.level[lane];
  }
  bool cannot_be_late(const Piece& piece, int lane) const;
  void wake_gently(Piece& piece);
  std::optional<double> waking(const Piece& piece, int lane) const;
  void wake_in_start(Piece& piece, int lane);
  void search_branch(const Piece& piece, int lane, Fall& fall) const;
  void search(const Piece& piece, Quantity quantity, int lane, double side, double level, Index guard,
              Fall& fall) const;

  Precision precision_;
  int last_clock_ = Expansion::plain;
  Values values_;
  Start start_;
  std::vector<Start::Part> parts_;
  std::array<std::unique_ptr<Expansion>, lane_sizes.size() + 1> expansions_;
  Expansion* series_ = nullptr;  ///< the one for the window
};

}  // namespace mariotte::flow::taylor
