// What a long run says on stderr meanwhile.
#pragma once
#include "mariotte/impact/watch/observers.hpp"
#include "status_line.hpp"

namespace mariotte::command {

/// From two seconds on.
class RunProgress {
 public:
  explicit RunProgress(double max_time) : max_time_(max_time) {}
  void operator()(const impact::Progress& progress);

 private:
  double max_time_;
  StatusLine line_{std::chrono::seconds(2)};
  Index asked_ = 0;
};

}  // namespace mariotte::command
