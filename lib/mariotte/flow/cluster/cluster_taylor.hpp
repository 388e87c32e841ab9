// Series of phases of balls in which several contacts are closed, by fields that are compiled.
#pragma once
#include "mariotte/flow/cluster/cluster_series.hpp"
#include "mariotte/flow/contact_steps.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"
#include "mariotte/flow/series_guards.hpp"

namespace mariotte::flow {

/// Follows such a phase. Outcome `stiff` where no series goes on: whoever knows others does.
class ClusterTaylor {
  using Field = ClusterField;
  using Kind = ClusterClock::Kind;

 public:
  /// On from where another expansion has come `so_far`.
  Arrival follow(const Problem& problem, ClusterPhase& phase, State x, const Request& request,
                 std::vector<Index>& fired, const Arrival& so_far) {
    problem_ = &problem;
    phase_ = &phase;
    accuracy_ = request.accuracy;
    phase.gather(x, false);
    return follow_by_series(*this, contact_limits, x, request, fired, so_far);
  }

  // What `follow_by_series` asks for.
  std::vector<double> before;
  int order() const { return series_order(accuracy_); }
  std::span<const double> time() const { return series_.time(); }

  /// As far as surely no contact closes that was left out; where that is hardly anywhere, they are listed
  /// anew, or none is left out.
  double expand(ConstState x, bool first) {
    expand_cluster(x, first);
    double step = step_length();
    stray_ = -1;
    for (int i = 0; !stays_far(x, step); ++i, step *= 0.5) {
      if (i < most_halvings) continue;
      if ((stray_ = phase_->stray(x)) >= 0) return 0;
      phase_->gather(x, true);
      expand_cluster(x, first);
      step = step_length();
      return stays_far(x, step) ? step : NAN;
    }
    return step;
  }

  SeriesEnd end(double reach, bool first, State) {
    if (stray_ >= 0) return {0, stray_};
    SeriesEnd end{reach};
    rounding_ = first ? accuracy_ : 0;
    for (int j = 0; j < std::ssize(cluster_->link); ++j) look_at_link(j, end);
    for (const auto& gap : cluster_->gap) look_at_gap(gap, end);
    return end;
  }

  void state(double place, ConstState from, State x) const {
    series_.move(place, motion_);
    phase_->move(from, motion_, x);
  }

  void fire(Index guard, ConstState x, std::vector<Index>& fired) {
    fired.push_back(guard);
    simultaneous_.collect(*problem_, x, simultaneity_window(*problem_, accuracy_), fired);
  }

  void add_forces(double end, std::vector<ForceSeries>& list) const {
    for (int j = 0; j < std::ssize(cluster_->link); ++j)
      list.push_back({series_.row(Field::force, j), series_.row(Field::friction, j),
                      series_.row(Field::depth, j), false, end});
  }

  double natural_time() const { return problem_->time_scale(); }
  bool is_stalled(const Step& step) const { return step.end - step.start < short_step * natural_time(); }

 private:
  const Problem* problem_ = nullptr;
  ClusterPhase* phase_ = nullptr;
  const Cluster* cluster_ = nullptr;
  double accuracy_ = 0, rounding_ = 0;
  double duration_ = 0;  ///< of a step, at most
  Index stray_ = -1;     ///< guard of a ball that may leave its place in this step
  ClusterClock clock_;
  ClusterSeries series_;
  Simultaneous simultaneous_;
  std::vector<double> first_cap_, reach_;
  mutable ClusterMotion motion_ = {};

  void expand_cluster(ConstState x, bool first) {
    cluster_ = &phase_->load(x, first);
    clock_ = clock();
    series_.expand(*cluster_, clock_, order());
    if (!first) return;
    first_cap_.clear();
    for (int j = 0; j < std::ssize(cluster_->link); ++j)
      first_cap_.push_back(cluster_->link[j].cap * series_.row(Field::force, j)[0]);
  }

  /// That of the contact that begins, or is nearest in time to where its root is singular.
  ClusterClock clock() const {
    const auto& link = cluster_->link;
    const auto starts = [](const ClusterLink& one) { return one.begins && one.has_root; };
    if (std::count_if(link.begin(), link.end(), starts) > 1) return {Kind::onset};
    ClusterClock chosen;
    double nearest = infinity;
    for (int j = 0; j < std::ssize(link); ++j)
      if (const double time = time_to_root(link[j]); time < nearest) nearest = time, chosen = {Kind::root, j};
    return chosen;
  }
  /// A contact that has hardly begun grows by a high power of the time in the wake of others: the root of any
  /// of these is the better clock.
  static double time_to_root(const ClusterLink& one) {
    constexpr double shallow = 1e-3;  // of the natural length
    if (!one.has_root) return infinity;
    if (one.begins) return 0;
    const double depth = one.start[Field::depth];
    const double approach = -one.start[Field::normal_x] * one.start[Field::velocity_x] -
                            one.start[Field::normal_y] * one.start[Field::velocity_y];
    const bool has_hardly_begun = approach > 0 && depth * one.weight[Field::depth] < shallow;
    return has_hardly_begun ? std::numeric_limits<double>::max() : depth / std::abs(approach);
  }

  double step_length() const {
    return reach_of_last(series_.time(), order(), most_of_last(accuracy_),
                         [&](int k) { return series_.size(k); });
  }

  bool stays_far(ConstState x, double step) {
    if (!std::isfinite(step)) return true;
    duration_ = most_change(series_.time(), step);
    reach_.clear();
    for (int i = 0; i < std::ssize(cluster_->ball); ++i) {
      const auto most = [&](int axis) {
        const auto row = series_.ball(i, axis);
        return std::abs(row[0]) + most_change(row, step);
      };
      reach_.push_back(duration_ * std::hypot(most(0), most(1)));
    }
    return phase_->stays_far(x, duration_, reach_);
  }

  using Row = std::array<double, ClusterSeries::most_order + 1>;

  void look_at_link(int j, SeriesEnd& end) {
    const auto& one = cluster_->link[j];
    const bool owns = clock_.kind == Kind::root && clock_.owner == j;
    look(one.open, {owns ? series_.clock() : series_.row(Field::depth, j)}, rounding_, end);
    const double turn = one.unloading ? -1 : 1;
    look(one.turn, {series_.row(Field::approach, j), turn, turn * one.rate_noise}, rounding_, end);
    if (one.friction < 0) return;
    if (!one.sticks)
      return look(one.friction, {series_.row(Field::yielding, j), one.sign, one.sign * one.rate_noise},
                  rounding_, end);
    for (const double sign : {1.0, -1.0}) look_at_cap(j, sign, end);
  }

  /// The cap is allowed some noise, as friction that starts at its cap leaves it, or a slip that is none.
  void look_at_cap(int j, double sign, SeriesEnd& end) {
    const auto& one = cluster_->link[j];
    const auto force = series_.row(Field::force, j), friction = series_.row(Field::friction, j);
    Row row;
    for (std::size_t k = 0; k < force.size(); ++k) row[k] = one.cap * force[k] - sign * friction[k];
    const double noise = one.cap_noise * first_cap_[j] + one.force_noise;
    look(one.friction, {{row.data(), force.size()}, 1, noise}, rounding_, end);
  }

  void look_at_gap(const ClusterGap& gap, SeriesEnd& end) {
    if (gap.gap - gap.touch_depth > reach_[gap.b] + reach_of_other(gap)) return;
    if (gap.part < 0 && series_.least_rate(gap, end.place) >= 0) return;
    Row row;
    const std::span<double> all(row.data(), order() + 1);
    row[0] = 0;
    series_.change(gap, all);
    look(gap.close, {all, 1, gap.beyond(gap.touch_depth)}, rounding_, end);
    if (gap.part >= 0) look(gap.part, {all, -1, gap.beyond(-gap.touch_depth)}, rounding_, end);
  }
  double reach_of_other(const ClusterGap& gap) const {
    return gap.a >= 0 ? reach_[gap.a] : duration_ * std::hypot(gap.velocity_x, gap.velocity_y);
  }
};

}  // namespace mariotte::flow
