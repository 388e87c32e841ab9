// Taylor series of every kind of contact of two balls. Code compiled for different instruction sets shares
// nothing but this layout.
#pragma once
#include <memory>
#include <span>

#include "mariotte/flow/balls/ball_phase.hpp"
#include "mariotte/flow/instruction_set.hpp"

namespace mariotte::flow {

/// Memory of one run, and the coefficients of its last expansion.
class BallExpansions {
 public:
  static constexpr int most_order = 22;
  using Row = std::array<double, most_order + 2>;
  virtual ~BallExpansions() = default;
  /// Coefficients 0 … order of all rows of `BallMotion`.
  virtual void expand(const BallContact& contact, const BallPhase::Motion& start, int order) = 0;
  std::span<const double> operator[](int row) const {
    return {row_[row].data(), static_cast<std::size_t>(order_) + 1};
  }
  /// All states at a place.
  virtual BallPhase::Motion at(double place) const = 0;

 protected:
  const Row* row_ = nullptr;
  int order_ = 0;
};

MARIOTTE_PER_INSTRUCTION_SET(std::unique_ptr<BallExpansions>, make_ball_expansions, (), ())

}  // namespace mariotte::flow
