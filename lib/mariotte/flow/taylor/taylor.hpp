// Taylor series of high order for contacts whose force is a sum of powers: the explicit flow.
#pragma once
#include <memory>
#include <vector>

#include "mariotte/flow/flow.hpp"

namespace mariotte::flow {

/// Expands the contacts that carry force, in time or in the clock dt = √δ dσ of the contact that is about to
/// let go, in which separation is an ordinary point. The polynomial of a step is its dense output and the
/// proof that no guard has fired within it. The order follows from the accuracy.
class Taylor final : public Flow {
 public:
  Taylor();
  ~Taylor() override;
  /// True if the phase is a row of bodies, or contacts that link dofs in any way, none of which with strong
  /// damping touches at rest.
  bool fits(const Problem& problem) const override { return !problem.tip() && !problem.recorded(); }
  bool admits(const Problem& problem) override;
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::flow
