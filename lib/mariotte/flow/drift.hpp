// Free flight of bodies that know their own closed form.
#pragma once
#include <vector>

#include "mariotte/flow/flow.hpp"

namespace mariotte::flow {

/// Follows phases with a `free_motion()`.
class Drift final : public Flow {
 public:
  bool fits(const Problem& problem) const override { return problem.free_motion() != nullptr; }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  std::vector<double> start_;
};

}  // namespace mariotte::flow
