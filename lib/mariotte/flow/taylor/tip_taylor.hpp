// Taylor series for one tip of a symmetric body in contact with a plane.
#pragma once
#include <memory>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/tip_phase.hpp"

namespace mariotte::flow {

/// Follows phases with a `tip()`: the series of their motion, normal, planar or spatial, of an order that
/// depends on the accuracy, and as far as the last coefficients allow. Guards are polynomials of the step;
/// that they keep their sign is proven, so no event is missed.
class TipTaylor final : public Flow {
 public:
  TipTaylor();
  ~TipTaylor() override;
  bool admits(const Problem& problem) override;
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::flow
