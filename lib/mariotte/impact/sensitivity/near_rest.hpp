// Slips in space that pass by rest: friction turns about within the time that such a slip takes, and its
// direction there is known as well as the slip.
#pragma once
#include <algorithm>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::impact {

/// How slow slips have become that grew again.
class NearRest {
 public:
  /// The slip of a contact behind a step.
  void see(Index contact, double slip) {
    if (contact >= std::ssize(slip_)) slip_.resize(static_cast<std::size_t>(contact) + 1);
    auto& one = slip_[contact];
    one.least = std::min(one.least, slip);
    if (one.least < 0.5 * one.most && slip > 2 * one.least) {
      closest_ = std::min(closest_, one.least);
      one = {};
    }
    one.least = std::min(one.least, slip);
    one.most = std::max(one.most, slip);
  }
  /// A contact that does not slip, or has come to rest.
  void forget(Index contact) {
    if (contact < std::ssize(slip_)) slip_[contact] = {};
  }
  /// Infinity if none has.
  double closest() const { return closest_; }

 private:
  struct Slip {
    double least = infinity, most = 0;  ///< since it last was near rest
  };
  std::vector<Slip> slip_;
  double closest_ = infinity;
};

}  // namespace mariotte::impact
