// How far a sweep is, for who waits: a bar on a terminal, else a line every ten seconds.
#pragma once
#include <chrono>
#include <string>

#include "mariotte/core/types.hpp"

namespace mariotte::command {

/// "[#####-----]  50 %  500 of 1000  100/s  5 s left" with the points of this run out of those it has to do.
std::string progress_text(Index done, Index points, double seconds, int bar_width);

class ProgressLine {
 public:
  /// `points` are still to do. A quiet one says nothing.
  ProgressLine(Index points, bool quiet);
  ~ProgressLine();  ///< wipes the bar
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(Index done);

 private:
  using Clock = std::chrono::steady_clock;
  Index points_;
  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point shown_ = start_;
};

}  // namespace mariotte::command
