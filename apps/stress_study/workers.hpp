// Processes that examine scenes: one that hangs or crashes is a finding, and another takes its place.
#pragma once
#include <cstdint>
#include <functional>

#include "examine.hpp"

namespace mariotte::stress_study {

/// What is examined, and how many at once.
struct Campaign {
  std::vector<Family> families;
  std::uint64_t seed = 1;
  std::uint64_t first = 0;
  int workers = 1;
  double patience = 5;  ///< CPU time of one run [s]
  bool brisk = false;   ///< only what is quick
};

/// Examine scenes from the first on as long as `more` says so; verdicts come as they are ready. Throws
/// std::system_error.
void examine_all(const Campaign& campaign, const std::function<bool(std::uint64_t scene)>& more,
                 const std::function<void(const Verdict&)>& take);

}  // namespace mariotte::stress_study
