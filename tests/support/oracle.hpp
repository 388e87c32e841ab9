// Which contacts carry force when, found without the library: the series of every step is looked at point by
// point, with every turning point of every guard between them.
#pragma once
#include <optional>

#include "support/course.hpp"

namespace mariotte::test {

/// A turning point of the guard of one contact, whose sign says whether the contact carries force: a minimum
/// within or behind the stretch of carrying force number `stretch` (from 1), or a maximum.
struct Probe {
  std::size_t contact = 0;
  bool minimum = true;
  std::size_t stretch = 1;
  bool operator==(const Probe&) const = default;
};

/// The guard's value there, in units of the contact's own length or load.
struct Turn {
  Probe probe;
  double value;
};

/// What the oracle knows of a chain.
struct Truth {
  std::vector<std::size_t> periods;  ///< stretches of carrying force, per contact
  std::vector<Turn> turns;           ///< in order of time
  /// How far the least clear decision was from going the other way: the smallest turning value, or the
  /// smallest final speed of parting in units of the incident speed.
  double margin = infinity;
  double time = 0;        ///< of the end
  bool complete = false;  ///< the impact has ended, or time has run out
};

class Oracle {
 public:
  explicit Oracle(const model::Chain& chain)
      : motion_(chain), gravity_(chain.gravity != 0), depth_(chain.law.size()), load_(chain.law.size()) {
    for (std::size_t j = 0; j < motion_.spring.size(); ++j) {
      const double approach = chain.velocity[j] - chain.velocity[j + 1];
      state_.push_back(State::apart);
      periods_.push_back(0);
      if (chain.gap[j] == 0 && approach > 0) enter(j, touched(j));
    }
  }

  Truth truth(double until = infinity) {
    while (!over() && time_ < until && step(until)) {
    }
    truth_.complete = over() || time_ >= until;
    if (!gravity_)
      for (std::size_t j = 0; j < state_.size(); ++j) note(approach(j) / motion_.speed);
    truth_.periods = periods_;
    truth_.time = time_;
    return truth_;
  }

  /// Value of the first turning point of that kind if the contact's mode is held fixed, so that the decision
  /// has no consequences: closed from that stretch on for a minimum, open behind it for a maximum. Empty if
  /// there is none.
  std::optional<double> turning_value(const Probe& probe, double until = infinity) {
    probe_ = probe;
    while (!found_ && !lost_ && !over() && time_ < until && step(until)) {
    }
    return lost_ ? std::nullopt : found_;
  }

  const std::vector<double>& velocity() const { return motion_.velocity; }

 private:
  /// Faint contacts carry force too little to matter; slack ones are indented without force.
  enum class State { apart, faint, pressing, slack };
  struct Change {
    double time = infinity;
    std::size_t contact = 0;
    State next = State::apart;
  };

  static bool carries(State state) { return state == State::faint || state == State::pressing; }
  double approach(std::size_t j) const { return motion_.velocity[j] - motion_.velocity[j + 1]; }
  bool damped(std::size_t j) const { return motion_.spring[j].damping > 0; }
  State touched(std::size_t j) const { return motion_.spring[j].root ? State::faint : State::pressing; }
  void note(double value) { truth_.margin = std::min(truth_.margin, std::abs(value)); }

  void enter(std::size_t j, State next) {
    periods_[j] += carries(next) && !carries(state_[j]);
    state_[j] = next;
    motion_.pushes[j] = next == State::pressing;
  }

  bool over() const {
    if (gravity_) return false;
    for (std::size_t j = 0; j < state_.size(); ++j)
      if ((carries(state_[j]) && motion_.indentation[j] >= 0) || approach(j) > 0) return false;
    return true;  // a contact held closed may have a gap
  }

  void follow_guards(double end) {
    for (std::size_t j = 0; j < state_.size(); ++j) {
      depth_[j].series = motion_.delta[j];
      depth_[j].find_turns(end);
      if (!damped(j) || state_[j] == State::apart) continue;
      load_[j].series = motion_.load[j];
      load_[j].find_turns(end);
    }
  }

  /// The earlier of `first` and the instant at which sign · (guard − level) falls below zero.
  static void look(Change& first, const Course& course, double level, double sign, const Change& change,
                   double end) {
    const auto height = [&](double time) { return sign * (course.value(time) - level); };
    if (height(0) <= 0 && sign * course.series[1] < 0) {
      first = change;
      first.time = 0;
      return;
    }
    double from = 0;
    for (std::size_t i = 0; i <= course.turns.size() && from < first.time; ++i) {
      const double to = i < course.turns.size() ? course.turns[i] : end;
      if (height(to) < 0) {
        const double time = zero(height, from, to);
        if (time >= first.time) return;
        first = change;
        first.time = time;
        return;
      }
      from = to;
    }
  }

  /// The table of modes.
  void look(Change& first, std::size_t j, double end) const {
    const double faint = motion_.spring[j].faint;
    const auto &depth = depth_[j], &load = load_[j];
    const auto to = [&](State next) { return Change{.contact = j, .next = next}; };
    const bool let_go = !held(j, true), press = !held(j, false);
    switch (state_[j]) {
      case State::apart:
        if (press) look(first, depth, 0, -1, to(touched(j)), end);
        return;
      case State::faint:
        look(first, depth, faint, -1, to(State::pressing), end);
        if (let_go && damped(j)) look(first, load, 0, 1, to(State::slack), end);
        if (let_go && !damped(j)) look(first, depth, 0, 1, to(State::apart), end);
        return;
      case State::pressing:
        if (faint > 0) look(first, depth, faint, 1, to(State::faint), end);
        if (let_go && damped(j)) look(first, load, 0, 1, to(State::slack), end);
        if (let_go && !damped(j) && faint == 0) look(first, depth, 0, 1, to(State::apart), end);
        return;
      case State::slack:
        if (press)
          look(first, load, 0, -1, to(depth.series[0] > faint ? State::pressing : State::faint), end);
        look(first, depth, 0, 1, to(State::apart), end);
    }
  }

  bool held(std::size_t j, bool closed) const {
    return probe_ && probe_->contact == j && probe_->minimum == closed && periods_[j] == probe_->stretch;
  }

  /// Turning values up to `end` go into the margin; the probed one ends the search.
  void look_at_turns(std::size_t j, double end) {
    const bool loaded = damped(j) && state_[j] != State::apart;
    const auto& course = loaded ? load_[j] : depth_[j];
    const double unit = loaded ? motion_.spring[j].load : motion_.spring[j].length;
    bool minimum = course.series[1] < 0;
    for (const double time : course.turns) {
      if (time > end) return;
      const double at = course.value(time) / unit;
      note(at);
      truth_.turns.push_back({{.contact = j, .minimum = minimum, .stretch = periods_[j]}, at});
      if (probe_ && !found_ && truth_.turns.back().probe == *probe_ && (minimum || !carries(state_[j])))
        found_ = at;
      minimum = !minimum;
    }
  }

  bool step(double until) {
    if (++steps_ > 3000) return false;
    motion_.expand();
    double end = std::min(motion_.reach(), until - time_);
    if (std::isinf(end)) end = free_flight();
    follow_guards(end);
    Change change;
    for (std::size_t j = 0; j < state_.size(); ++j) look(change, j, end);
    end = std::min(end, change.time);
    for (std::size_t j = 0; j < state_.size(); ++j) look_at_turns(j, end);
    motion_.advance(end);
    time_ += end;
    if (change.time == end) apply(change);
    return true;
  }

  void apply(const Change& change) {
    const auto j = change.contact;
    // What is held, and has left the range in which holding it has a meaning.
    if (probe_ && j == probe_->contact && periods_[j] == probe_->stretch && damped(j) &&
        (probe_->minimum ? change.next == State::faint && state_[j] == State::pressing
                         : change.next == State::apart))
      lost_ = true;
    if (damped(j) && state_[j] == State::apart)
      note(motion_.spring[j].damping * approach(j) / motion_.spring[j].load);
    enter(j, change.next);
  }

  /// Nothing pushes: twice the time to the last of the meetings.
  double free_flight() const {
    double longest = 0;
    for (std::size_t j = 0; j < state_.size(); ++j)
      if (approach(j) > 0) longest = std::max(longest, 2 * std::abs(motion_.indentation[j]) / approach(j));
    for (std::size_t j = 0; j < state_.size(); ++j)
      longest = std::max(longest, 2 * motion_.spring[j].length / motion_.speed);
    return longest;
  }

  SeriesMotion motion_;
  bool gravity_;
  std::vector<State> state_;
  std::vector<std::size_t> periods_;
  std::vector<Course> depth_, load_;  ///< of every contact over the present step
  Truth truth_;
  double time_ = 0;
  int steps_ = 0;
  std::optional<Probe> probe_;
  std::optional<double> found_;
  bool lost_ = false;
};

}  // namespace mariotte::test
