#include "mariotte/flow/balls/ball_taylor.hpp"
#include "mariotte/flow/cluster/cluster_taylor.hpp"
#include "mariotte/flow/contact_steps.hpp"
#include "mariotte/flow/flows.hpp"
#include "mariotte/flow/recorded/recorded_phase.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"
#include "mariotte/flow/series_guards.hpp"

namespace mariotte::flow {
namespace {

using series::TapeClock;
using series::TapeSeries;

/// Of the series in τ so many last coefficients may be incomplete.
constexpr int onset_loss = 4;

/// Largest place at which none of the last terms of a component exceeds what it may.
double step_length(const Recording& recording, const TapeSeries& series, ConstState magnitude,
                   double accuracy, int order) {
  return reach_of_last(series.time(), order, most_of_last(accuracy), [&](int k) {
    double size = 0;
    for (std::size_t i = 0; i < recording.state.size(); ++i)
      size = std::max(size,
                      std::abs(series.row(recording.state[i].place)[k]) / magnitude[recording.component[i]]);
    return size;
  });
}

/// The guard that opens the contact of this clock, in whose series it is a root of first order; or −1.
Index landing_guard(const Recording& recording, const TapeClock& clock) {
  if (clock.kind != TapeClock::Kind::root) return -1;
  for (const auto& one : recording.contact)
    if (one.root == clock.root) return one.open;
  return -1;
}

/// What `follow_by_series` drives.
struct Expansion {
  Recording recording;
  TapeSeries series;
  std::vector<double> before;

  void begin(const Problem& problem, ConstState x, double asked) {
    problem_ = &problem;
    phase_ = problem.recorded();
    asked_ = asked;
    accuracy_ = resolving_accuracy(problem, asked, 64 * epsilon);
    record(x, false);
  }

  void record(ConstState x, bool all) {
    phase_->record(x, asked_, all, recording);
    seen_.clear();
    clocks_.clear();
    for (const auto& one : recording.guard) seen_.push_back(one.place);
    for (const auto& one : recording.contact) {
      for (const int place : {one.depth, one.left, one.normal, one.friction}) seen_.push_back(place);
      if (one.root >= 0) clocks_.push_back(one.root);
    }
    series.prepare(recording.tape, recording.state, clocks_, seen_);
  }

  int order() const { return series_order(accuracy_); }
  std::span<const double> time() const { return series.time(); }

  /// As far as surely nothing fires that has not been recorded; where that is hardly anywhere, all is.
  double expand(ConstState x, bool first) {
    double reach = expand_recorded(x, first);
    for (int i = 0; recording.is_partial && !stays_far(x, reach); ++i, reach *= 0.5) {
      if (i < most_halvings) continue;
      record(x, true);
      return expand_recorded(x, first);
    }
    return reach;
  }

  double expand_recorded(ConstState x, bool first) {
    load(x);
    clock_ = clock(first);
    const bool onset = clock_.kind == TapeClock::Kind::onset;
    series.expand(values_, order() + (onset ? onset_loss : 0), clock_);
    return step_length(recording, series, problem_->magnitudes(), accuracy_, order());
  }

  SeriesEnd end(double reach, bool first, State x) {
    const double rounding = first ? accuracy_ : 0;
    const Index landing = landing_guard(recording, clock_);
    SeriesEnd end{reach};
    if (landing >= 0) look(landing, {series.row(clock_.root)}, rounding, end);
    for (const auto& one : recording.guard)
      if (one.guard != landing) look(one.guard, {series.row(one.place), one.sign}, rounding, end);
    if (end.guard >= 0 && end.place > 0 && end.guard != landing) sharpen(end, x);
    return end;
  }

  void state(double place, ConstState from, State x) const {
    std::copy(from.begin(), from.end(), x.begin());
    phase_->fly_others(from, horner(time(), place), x);
    for (std::size_t i = 0; i < recording.state.size(); ++i)
      x[recording.component[i]] = horner(series.row(recording.state[i].place), place);
  }

  void fire(Index guard, ConstState x, std::vector<Index>& fired) {
    fired.push_back(guard);
    simultaneous_.collect(*problem_, x, simultaneity_window(*problem_, asked_), fired);
  }

  void add_forces(double end, std::vector<ForceSeries>& list) const {
    for (const auto& one : recording.contact)
      list.push_back(
          {series.row(one.normal), series.row(one.friction), series.row(one.depth), one.is_square, end});
  }

  double natural_time() const { return problem_->time_scale(); }
  bool is_stalled(const Step& step) const { return step.end - step.start < short_step * natural_time(); }

  /// A contact that opens at once and is so shallow that it does nothing any more: the guard that opens it,
  /// after the time that it still takes. No series passes the end of some of them. One that parts more slowly
  /// may be pressed again before it has opened.
  std::optional<std::pair<Index, double>> opening(ConstState x) {
    load(x);
    series.expand(values_, 1, {});
    for (const auto& one : recording.contact) {
      const auto left = series.row(one.left);
      const double time = -left[0] / left[1];
      if (left[1] < 0 && left[0] < one.negligible && time < short_step * problem_->time_scale())
        return std::pair(one.open, time);
    }
    return std::nullopt;
  }

  /// Along the tangent.
  void move_on(double duration, State x) {
    values_.resize(x.size());
    problem_->derivative(x, values_);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += duration * values_[i];
  }

 private:
  const Problem* problem_ = nullptr;
  const RecordedPhase* phase_ = nullptr;
  double asked_ = 0, accuracy_ = 0;
  TapeClock clock_;
  Simultaneous simultaneous_;
  std::vector<int> clocks_, seen_;
  std::vector<double> values_, guards_, moves_;

  void load(ConstState x) {
    values_.resize(recording.component.size());
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = x[recording.component[i]];
  }

  bool stays_far(ConstState x, double reach) {
    if (!std::isfinite(reach)) return true;
    moves_.assign(x.size(), 0.0);
    for (std::size_t i = 0; i < recording.state.size(); ++i)
      moves_[recording.component[i]] = most_change(series.row(recording.state[i].place), reach);
    return phase_->stays_far(x, most_change(time(), reach), moves_);
  }

  /// The clock of the contact that is nearest in time to where its root is singular.
  TapeClock clock(bool first) {
    if (clocks_.empty()) return {};
    const auto begins = [](const RecordedContact& one) { return one.begins && one.root >= 0; };
    if (first && std::any_of(recording.contact.begin(), recording.contact.end(), begins))
      return {.kind = TapeClock::Kind::onset};
    series.expand(values_, 1, {});
    double nearest = infinity;
    TapeClock chosen{.kind = TapeClock::Kind::root, .root = clocks_.front()};
    for (const auto& one : recording.contact) {
      const auto left = series.row(one.left);
      const double time = left[0] / std::abs(left[1]);
      if (one.root >= 0 && time < nearest) nearest = time, chosen.root = one.root;
    }
    return chosen;
  }

  double guard(Index which, double place, State x) {
    state(place, before, x);
    guards_.resize(problem_->guard_count());
    problem_->guards(x, guards_);
    return guards_[which];
  }

  /// A guard may be a product of what moves, and so less sharp than that: its root is found again from
  /// states, by secants. Near a bend of the guard one may lead away: its end is then the far one of the next.
  void sharpen(SeriesEnd& end, State x) {
    double far = (1 - 1e-3) * end.place, past = guard(end.guard, far, x),
           now = guard(end.guard, end.place, x);
    double most = 1e-2 * end.place;
    for (int i = 0; i < 6; ++i) {
      const double move = -now * (end.place - far) / (now - past);
      if (!(std::abs(move) < most)) return;  // what does not come closer is rounding
      most = 0.5 * std::abs(move);
      far = end.place + move;
      past = guard(end.guard, far, x);
      if (std::abs(past) < std::abs(now)) std::swap(past, now), std::swap(far, end.place);
      if (std::abs(move) <= 4 * epsilon * end.place) return;
    }
  }
};

class RecordedTaylor final : public Flow {
 public:
  bool fits(const Problem& problem) const override { return problem.recorded() != nullptr; }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override {
    Arrival so_far;
    if (auto* balls = problem.recorded()->balls()) {
      if (!balls_) balls_.emplace();
      so_far = balls_->follow(problem, *balls, x, request, fired);
      if (so_far.outcome != Outcome::stiff) return so_far;
    }
    if (auto* cluster = problem.recorded()->cluster()) {
      if (!cluster_) cluster_.emplace();
      so_far = cluster_->follow(problem, *cluster, x, request, fired, so_far);
      if (so_far.outcome != Outcome::stiff) return so_far;
    }
    expansion_.begin(problem, x, request.accuracy);
    auto arrival = follow_by_series(expansion_, contact_limits, x, request, fired, so_far);
    if (arrival.outcome != Outcome::stiff) return arrival;
    const auto opens = expansion_.opening(x);
    if (!opens || arrival.duration + opens->second > request.limit) return arrival;
    expansion_.move_on(opens->second, x);
    expansion_.fire(opens->first, x, fired);
    arrival.outcome = Outcome::guard;
    arrival.duration += opens->second;
    return arrival;
  }

 private:
  std::optional<BallTaylor> balls_;  ///< these two are made when first needed
  std::optional<ClusterTaylor> cluster_;
  Expansion expansion_;
};

}  // namespace

std::unique_ptr<Flow> make_recorded_flow() {
  return std::make_unique<RecordedTaylor>();
}

}  // namespace mariotte::flow
