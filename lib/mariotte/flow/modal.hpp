// Linear undamped contacts: the motion is a sum of natural modes, nothing is integrated.
#pragma once
#include <memory>

#include "mariotte/flow/flow.hpp"

namespace mariotte::flow {

/// With z = √K δ the closed contacts obey z̈ = −C Cᵀ z, C = √K G M^{−1/2}. The singular values of C are the
/// natural frequencies; taking them from C, not from C Cᵀ, keeps the low ones exact beside contacts 10^10
/// times as stiff.
class Modal final : public Flow {
 public:
  Modal();
  ~Modal() override;
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::flow
