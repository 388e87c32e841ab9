// One series of the Taylor flow and how far it is followed.
#pragma once
#include <array>
#include <span>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/taylor/taylor_start.hpp"
#include "mariotte/flow/taylor/taylor_window.hpp"

namespace mariotte::flow::taylor {

/// A series and how far it is followed.
struct Piece {
  Expansion* series = nullptr;   ///< null for the start series
  const Start* start = nullptr;  ///< null for the others
  int order = 0;
  int clock = Expansion::plain;
  double end = 0;       ///< last place of the clock
  bool lands = false;   ///< ends where the contact of the clock lets go
  bool is_cut = false;  ///< ends at the time to which it was to go at most

  void evaluate(double place, Values& values) const {
    series ? series->evaluate(place, values) : start->evaluate(place, values);
  }
  std::span<const double> coefficients(Quantity quantity, int lane, Coefficients& c) const;
  /// The place reached at `time`, if `end` is reached at end_time ≥ time.
  double place(double time, double end_time) const;
};

/// A piece as a step for those who watch: its polynomials are the dense output.
class PieceStep final : public Step {
 public:
  /// `scratch` is room for the values of all lanes.
  PieceStep(const Window& window, const Piece& piece, double duration, Values& scratch)
      : window_(window), piece_(piece), duration_(duration), scratch_(scratch) {}
  void at(double time, State x) const override;
  void inside(double fraction, State x) const override;
  bool series(PushSeries& push) const override;
  bool indentation(Index gap, IndentationSeries& motion) const override;

 private:
  bool acts(int lane) const;
  void show(double place, State x) const;
  void fill_force(int lane, PushSeries::Contact& contact) const;
  void fill_motion(int lane, PushSeries::Contact& contact) const;

  const Window& window_;
  const Piece& piece_;
  double duration_;
  Values& scratch_;
};

}  // namespace mariotte::flow::taylor
