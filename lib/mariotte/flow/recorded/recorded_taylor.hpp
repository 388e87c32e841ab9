// Taylor series of a recorded field: the explicit flow for phases of any shape.
#pragma once
#include <memory>

#include "mariotte/flow/flow.hpp"

namespace mariotte::flow {

/// Expands everything that is in contact in one clock: t = τ² where contacts begin, dt = √δ dσ of the contact
/// that is nearest to its beginning or end, else time. Guards are polynomials, and so certified.
class RecordedTaylor final : public Flow {
 public:
  RecordedTaylor();
  ~RecordedTaylor() override;
  bool fits(const Problem& problem) const override { return problem.recorded() != nullptr; }
  bool admits(const Problem& problem) override { return problem.recorded() != nullptr; }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::flow
