// Linear contacts, damped or not: the motion is a sum of natural modes, nothing is integrated.
#pragma once
#include <memory>

#include "mariotte/flow/flow.hpp"

namespace mariotte::flow {

/// Cost depends neither on stiffness nor on damping groups; nothing is allocated after the first phase of a
/// size.
class Modal final : public Flow {
 public:
  Modal();
  ~Modal() override;
  /// False unless all contacts that act are linear, and where modes are so nearly alike that they cannot
  /// carry the motion: within about 10⁻⁴ of critical damping of some mode, if the ratio of damping to
  /// stiffness is not the same in all contacts that shake each other.
  bool admits(const Problem& problem) override;
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::flow
