// The general engine: CVODE with root-finding [Hindmarsh et al. 2005]. It follows any law.
#pragma once
#include <memory>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/kind.hpp"

namespace mariotte::flow {

/// Adams (order ≤ 12) with fixed-point iteration, or BDF (order ≤ 5) with Newton on a dense, band or sparse
/// matrix. Keeps its memory between phases; made for problems of one size, pattern and number of guards.
class Cvode final : public Flow {
 public:
  Cvode(Kind kind, const Problem& like);
  ~Cvode() override;
  bool fits(const Problem& problem) const override;
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// Version of SUNDIALS at run time, such as "6.4.1".
std::string sundials_version();

}  // namespace mariotte::flow
