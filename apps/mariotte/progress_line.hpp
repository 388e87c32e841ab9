// How far a sweep is, for who waits: a bar on a terminal, else a line every ten seconds.
#pragma once
#include <string>

#include "mariotte/core/types.hpp"
#include "status_line.hpp"

namespace mariotte::command {

/// "[#####-----]  50 %  500 of 1000  100/s  5 s left" with the points of this run out of those it has to do.
std::string progress_text(Index done, Index points, double seconds, int bar_width);

class ProgressLine {
 public:
  /// `points` are still to do. A quiet one says nothing.
  ProgressLine(Index points, bool quiet) : points_(points), quiet_(quiet) {}
  void show(Index done);

 private:
  Index points_;
  bool quiet_;
  StatusLine line_;
};

}  // namespace mariotte::command
