// Where errors grow by flying: an error of a velocity moves a body the more the longer it flies, and so the
// instants at which contacts that push together, or soon after each other, close.
#pragma once
#include <algorithm>

namespace mariotte {

/// Told of contacts that begin and end to push, in order of time.
class Flights {
 public:
  void begin(double time) {
    const bool is_first = closed_++ == 0, follows = is_first && is_soon(time);
    const double quiet = has_pushed_ ? time - last_ : 0;
    is_first ? together_.begin(time, quiet) : together_.join();
    is_first && !follows ? in_turn_.begin(time, quiet) : in_turn_.join();
    if (is_first) push_began_ = time;
    has_pushed_ = true;
  }
  void end(double time) {
    last_ = time;
    if (--closed_ == 0) longest_ = std::max({longest_, together_.flight(time), in_turn_.flight(time)});
  }
  /// How long nothing pushed before contacts did so together, or soon after each other, over how long they
  /// did; the longest.
  double longest() const { return longest_; }

 private:
  /// Contacts that push behind a flight.
  struct Group {
    double quiet = 0, began = 0;
    bool is_joined = false;

    void begin(double time, double quiet_before) { *this = {quiet_before, time, false}; }
    void join() { is_joined = true; }
    double flight(double time) const { return is_joined && quiet > 0 ? quiet / (time - began) : 0; }
  };

  /// After the last push: what a flight makes of instants may change who is first.
  bool is_soon(double time) const {
    constexpr double soon = 10;  // durations of that push
    return has_pushed_ && time - last_ < soon * (last_ - push_began_);
  }

  int closed_ = 0;
  bool has_pushed_ = false;
  double push_began_ = 0, last_ = 0, longest_ = 0;
  Group together_, in_turn_;  ///< that push at one time, or soon after each other as well
};

}  // namespace mariotte
