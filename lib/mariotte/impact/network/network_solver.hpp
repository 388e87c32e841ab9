// Many networks with the same memory: velocities, impulses and counts, and nothing that costs extra.
#pragma once
#include <memory>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/brief_impact.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::impact {

/// Solves one network after the other. After the first of its kind and size nothing is allocated, if the
/// mass matrix is diagonal. Not to be shared between threads; each has its own.
class NetworkSolver {
 public:
  NetworkSolver();
  ~NetworkSolver();
  /// As `simulate`, without peaks, balances and events; the result holds until the next call. Throws
  /// InvalidParameter for a network, accuracy or flow that makes no sense.
  const BriefImpact& solve(const model::Network& network, const hybrid::Options& options = {});

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::impact
