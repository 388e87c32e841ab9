// Series of phases in which one contact of balls is closed, by fields that are compiled.
#pragma once
#include "mariotte/flow/balls/ball_expansions.hpp"
#include "mariotte/flow/contact_steps.hpp"
#include "mariotte/flow/series_guards.hpp"

namespace mariotte::flow {

/// Follows such a phase. Outcome `stiff` where another contact may close: whoever knows all of them goes on.
class BallTaylor {
 public:
  Arrival follow(const Problem& problem, BallPhase& phase, State x, const Request& request,
                 std::vector<Index>& fired) {
    phase_ = &phase;
    contact_ = &phase.contact();
    accuracy_ = request.accuracy;
    shortest_ = short_step * problem.time_scale();
    return follow_by_series(*this, contact_limits, x, request, fired);
  }

  // What `follow_by_series` asks for.
  std::vector<double> before;
  /// What costs least; measured on random impacts of balls. Of a step more is spent on guards and states than
  /// on these series.
  int order() const { return accuracy_ > 1e-5 ? 16 : 20; }
  std::span<const double> time() const { return series_[BallMotion::time]; }

  double expand(ConstState x, bool first) {
    start_ = phase_->begin(x, first);
    expansions_->expand(*contact_, start_, order());
    if (first) first_cap_ = contact_->parameter[BallMotion::coulomb] * series_[BallMotion::force][0];
    return clear_length(x, step_length());
  }

  SeriesEnd end(double reach, bool first, State) {
    SeriesEnd end{reach};
    const auto visit = [&](Index guard, const GuardSeries& series) {
      look(guard, series, first ? accuracy_ : 0, end);
    };
    each_guard(reach, visit);
    place_ = end.place;
    return end;
  }

  void state(double place, ConstState from, State x) const { phase_->move(from, series_.at(place), x); }

  /// With it, what falls through zero within rounding of its place.
  void fire(Index guard, ConstState, std::vector<Index>& fired) {
    fired.push_back(guard);
    const double soon = place_ * (1 + 0.1 * accuracy_);
    each_guard(soon, [&](Index other, const GuardSeries& series) {
      const double ahead = series.at(soon);
      if (ahead > 0 || !(ahead < series.at(place_))) return;
      if (std::find(fired.begin(), fired.end(), other) == fired.end()) fired.push_back(other);
    });
  }

  void add_forces(double end, std::vector<ForceSeries>& list) const {
    list.push_back(
        {series_[BallMotion::force], series_[BallMotion::friction], series_[BallMotion::depth], false, end});
  }

  bool is_stalled(const Step& step) const { return step.end - step.start < shortest_; }

 private:
  using Row = std::array<double, BallExpansions::most_order + 1>;

  std::unique_ptr<BallExpansions> expansions_ = make_ball_expansions();
  const BallExpansions& series_ = *expansions_;
  BallPhase* phase_ = nullptr;
  const BallContact* contact_ = nullptr;
  BallPhase::Motion start_ = {};
  double accuracy_ = 0, shortest_ = 0, first_cap_ = 0, place_ = 0;

  double step_length() const {
    return reach_of_last(time(), order(), most_of_last(accuracy_), [&](int k) {
      double size = 0;
      for (int i = 0; i < BallMotion::states; ++i)
        size = std::max(size, std::abs(series_[i][k]) * contact_->weight[i]);
      return size;
    });
  }

  /// As much of a step as surely closes no other contact; no number if that is hardly any.
  double clear_length(ConstState x, double step) const {
    if (contact_->is_alone) return step;
    for (int i = 0; i <= most_halvings; ++i, step *= 0.5) {
      const auto most = [&](int row) { return std::abs(series_[row][0]) + most_change(series_[row], step); };
      const double speed = most(BallMotion::approach) + most(BallMotion::along);
      if (phase_->is_clear(x, most_change(time(), step), speed)) return step;
    }
    return NAN;
  }

  /// visit(guard, series): it fires where that falls through zero. Those that cannot before `place` are left
  /// out.
  template <class Visit>
  void each_guard(double place, Visit&& visit) const {
    const auto& c = *contact_;
    const double turn = c.unloading ? -1 : 1;
    if (may_open(place)) visit(c.open, GuardSeries{series_[BallMotion::root]});
    if (may_turn()) visit(c.turn, GuardSeries{series_[BallMotion::approach], turn, turn * c.rate_noise});
    if (c.friction < 0) return;
    Row row;
    if (!sticks(c.grip)) {
      visit(c.friction, GuardSeries{series_[BallMotion::watched], 1, c.rate_noise});
    } else if (c.grip == Grip::rigid_stick) {
      visit(c.friction, rigid_cap(row));
    } else {
      visit(c.friction, spring_cap(row, 1));
      visit(c.friction, spring_cap(row, -1));
    }
  }

  /// While a contact loads, x' = w/2 is not below the noise at which it turns.
  bool may_open(double place) const {
    return contact_->unloading || !(start_[BallMotion::root] > contact_->rate_noise * place);
  }
  /// While it unloads, nothing presses but gravity: all else in w' is negative.
  bool may_turn() const { return !contact_->unloading || contact_->parameter[BallMotion::pull_normal] < 0; }

  /// Caps are allowed some noise: of a spring a share of what it is at first, as friction that starts at its
  /// cap leaves it; of a rigid stick what does not matter where forces fade.
  GuardSeries spring_cap(Row& row, double sign) const {
    const auto force = series_[BallMotion::force], friction = series_[BallMotion::friction];
    for (std::size_t k = 0; k < force.size(); ++k)
      row[k] = contact_->parameter[BallMotion::coulomb] * force[k] - sign * friction[k];
    return {{row.data(), force.size()}, 1, contact_->force_share * first_cap_};
  }
  GuardSeries rigid_cap(Row& row) const {
    const auto force = series_[BallMotion::force], left = series_[BallMotion::watched];
    const double allowed = 2 * contact_->force_noise * contact_->parameter[BallMotion::coulomb];
    for (std::size_t k = 0; k < force.size(); ++k) row[k] = left[k] + allowed * force[k];
    return {{row.data(), force.size()}, 1, contact_->faint_force * contact_->faint_force};
  }
};

}  // namespace mariotte::flow
