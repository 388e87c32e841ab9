// Power series of a recorded field x' = f(x) in a clock, order by order.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "mariotte/series/tape.hpp"

namespace mariotte::series {

/// A component of the state that is expanded, and where its rate is on the tape.
struct TapeState {
  int place = -1;  ///< of the state on the tape
  int rate = -1;
  bool feeds = true;  ///< false of an integral that nothing else depends on
};

/// What a series is expanded in: time; a root √δ on the tape, dt = √δ dσ; t = τ², where contacts begin.
struct TapeClock {
  enum class Kind { time, root, onset } kind = Kind::time;
  int root = -1;
};

/// Rows of coefficients of everything on a tape. Keeps its memory.
class TapeSeries {
 public:
  static constexpr int order_limit = 29;
  static constexpr int stride = order_limit + 1;

  /// Get ready for a tape: what feeds the rates and the `clocks` (roots), and what only `seen` places
  /// (guards) need.
  void prepare(const Tape& tape, std::span<TapeState> state, std::span<const int> clocks,
               std::span<const int> seen);
  /// Expand from the state x, by component. In the clock τ the last four coefficients may be incomplete.
  void expand(std::span<const double> x, int order, const TapeClock& clock);

  std::span<const double> row(int place) const { return {&rows_[place * stride], std::size_t(order_) + 1}; }
  std::span<const double> time() const { return {time_, std::size_t(order_) + 1}; }

 private:
  double* at(int place) { return &rows_[place * stride]; }
  void start(std::span<const double> x, const TapeClock& clock);
  void coefficient(const TapeNode& node, int place, int k);
  void late_quotient(const TapeNode& node, int place);
  void late_root(const TapeNode& node, int place);
  void onset_root(const TapeNode& node, int place, int k);
  double rate(int place, int k) const;
  void advance(const TapeState& one, int k);
  void see();

  const Tape* tape_ = nullptr;
  std::span<TapeState> state_;
  std::vector<int> feeding_, seen_;
  std::vector<char> need_;
  std::vector<int> lag_;
  std::vector<double> rows_;
  double time_[stride] = {};
  int order_ = 0;
  TapeClock clock_;
};

}  // namespace mariotte::series
