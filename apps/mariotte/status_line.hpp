// One line on stderr that says how far something is: on a terminal it is written over, else it comes every
// ten seconds.
#pragma once
#include <chrono>
#include <string>

namespace mariotte::command {

class StatusLine {
 public:
  using Clock = std::chrono::steady_clock;

  StatusLine();
  /// The first one is due so long after the start.
  explicit StatusLine(Clock::duration first);
  ~StatusLine();  ///< wipes it off a terminal
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  bool on_terminal() const { return terminal_; }
  bool is_due() const { return Clock::now() >= due_; }
  double seconds() const;  ///< since the start
  void show(const std::string& text);

 private:
  Clock::duration interval() const;

  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point due_;
};

}  // namespace mariotte::command
