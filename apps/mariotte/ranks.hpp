// The processes that work on one sweep: those that mpirun has started, or this one alone.
#pragma once
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::command {

class Ranks {
 public:
  Ranks();  ///< joins the others; throws UsageError if there are some and this build has no MPI
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  Index rank() const { return rank_; }
  Index count() const { return count_; }
  bool first() const { return rank_ == 0; }

  /// Returns when all have come here.
  void meet() const;

  /// Ends the processes of all ranks; mpirun returns the code.
  [[noreturn]] void end_all(int code) const;

  /// Tells the first rank how many points this one has done. Of all, as far as known; on other ranks of this.
  Index tell(Index done);

 private:
  void collect();

  Index rank_ = 0;
  Index count_ = 1;
  bool joined_ = false;
  std::vector<long long> done_;  ///< by rank; on others than the first only its own
};

}  // namespace mariotte::command
