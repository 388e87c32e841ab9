// Taylor series of one contact of balls in the plane.
#pragma once
#include <span>

#include "mariotte/flow/balls/ball_expansions.hpp"

namespace mariotte::flow {

/// Memory of one run, and the coefficients of its last expansion.
class BallSeries {
 public:
  static constexpr int most_order = BallExpansions::most_order;

  /// Coefficients 0 … order of every row.
  void expand(const BallContact& contact, const BallPhase::Motion& start, int order) {
    order_ = order;
    row_ = expansions_->expand(contact, start, order);
  }
  std::span<const double> operator[](int row) const {
    return {row_[row].data(), static_cast<std::size_t>(order_) + 1};
  }
  /// All states at a place.
  BallPhase::Motion at(double place) const { return expansions_->at(place); }

 private:
  std::unique_ptr<BallExpansions> expansions_ = make_ball_expansions();
  const BallExpansions::Row* row_ = nullptr;
  int order_ = 0;
};

}  // namespace mariotte::flow
