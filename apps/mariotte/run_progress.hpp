// What a long run says on stderr meanwhile.
#pragma once
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/watch/observers.hpp"
#include "status_line.hpp"

namespace mariotte::command {

/// From two seconds on. Time left is judged by the limits of the run, so it is the most that it can take.
class RunProgress {
 public:
  explicit RunProgress(const hybrid::Options& limits) : limits_(limits) {}
  void operator()(const impact::Progress& progress);

 private:
  hybrid::Options limits_;
  StatusLine line_{std::chrono::seconds(2)};
  Index asked_ = 0;
};

}  // namespace mariotte::command
