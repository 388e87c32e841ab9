// What a long run says on stderr meanwhile.
#pragma once
#include <chrono>
#include <functional>

#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/sampling.hpp"

namespace mariotte::command {

/// From two seconds on, a line now and then: on a terminal one that is written over, else one every ten
/// seconds. Time left is judged by the limits of the run, so it is the most that it can take.
class RunProgress {
 public:
  explicit RunProgress(const hybrid::Options& limits) : limits_(limits) {}
  /// Clears its line.
  ~RunProgress();
  RunProgress(const RunProgress&) = delete;
  RunProgress& operator=(const RunProgress&) = delete;
  void operator()(const impact::Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;
  hybrid::Options limits_;
  Clock::time_point start_ = Clock::now(), next_ = start_ + std::chrono::seconds(2);
  Index asked_ = 0;
  bool shown_ = false;
};

}  // namespace mariotte::command
