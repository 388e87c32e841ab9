// What a long run says on stderr meanwhile.
#pragma once
#include <string>

#include "mariotte/impact/watch/observers.hpp"
#include "status_line.hpp"

namespace mariotte::command {

/// "at 1.2 ms after 3 s, 4000 events; about 5 s more to the time limit", if there is such a limit [s]:
/// nothing else tells how long a run goes on.
std::string progress_text(const impact::Progress& progress, double max_time, double taken);

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
