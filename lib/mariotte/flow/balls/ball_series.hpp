// Taylor series of one contact of balls in the plane.
#pragma once
#include <memory>
#include <span>

#include "mariotte/flow/balls/ball_phase.hpp"

namespace mariotte::flow {

/// Memory of one run, and the coefficients of its last expansion.
class BallSeries {
 public:
  static constexpr int most_order = 22;

  BallSeries();
  ~BallSeries();
  /// Coefficients 0 … order of every row.
  void expand(const BallContact& contact, const BallPhase::Motion& start, int order);
  std::span<const double> operator[](int row) const {
    return {row_[row].data(), static_cast<std::size_t>(order_) + 1};
  }
  /// All states at a place.
  BallPhase::Motion at(double place) const;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
  const std::array<double, most_order + 2>* row_ = nullptr;
  int order_ = 0;
};

}  // namespace mariotte::flow
