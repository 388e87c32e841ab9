#include "mariotte/flow/balls/ball_taylor.hpp"

#include "mariotte/flow/balls/ball_series.hpp"
#include "mariotte/flow/contact_steps.hpp"
#include "mariotte/flow/series_guards.hpp"

namespace mariotte::flow {
namespace {

using Row = std::array<double, BallSeries::most_order + 1>;

}  // namespace

/// What `follow_by_series` drives.
class BallTaylor::Expansion {
 public:
  std::vector<double> before;

  void begin(const Problem& problem, BallPhase& phase, double accuracy) {
    phase_ = &phase;
    contact_ = &phase.contact();
    accuracy_ = accuracy;
    shortest_ = short_step * problem.time_scale();
  }

  int order() const { return series_order(accuracy_); }
  std::span<const double> time() const { return series_[BallMotion::time]; }

  double expand(ConstState x, bool first) {
    start_ = phase_->begin(x, first);
    series_.expand(*contact_, start_, order());
    if (first) first_cap_ = contact_->parameter[BallMotion::coulomb] * series_[BallMotion::force][0];
    return clear_length(x, step_length());
  }

  SeriesEnd end(double reach, bool first, State) {
    SeriesEnd end{reach};
    each_guard([&](Index guard, std::span<const double> row, double sign) {
      look(guard, row, sign, first ? accuracy_ : 0, end);
    });
    place_ = end.place;
    return end;
  }

  void state(double place, ConstState from, State x) const { phase_->move(from, series_.at(place), x); }

  /// With it, what falls through zero within rounding of its place.
  void fire(Index guard, ConstState, std::vector<Index>& fired) {
    fired.push_back(guard);
    const double soon = place_ * (1 + 0.1 * accuracy_);
    each_guard([&](Index other, std::span<const double> row, double sign) {
      const double ahead = sign * horner(row, soon);
      if (ahead > 0 || !(ahead < sign * horner(row, place_))) return;
      if (std::find(fired.begin(), fired.end(), other) == fired.end()) fired.push_back(other);
    });
  }

  void add_forces(double end, std::vector<ForceSeries>& list) const {
    list.push_back(
        {series_[BallMotion::force], series_[BallMotion::friction], series_[BallMotion::depth], false, end});
  }

  bool is_stalled(const Step& step) const { return step.end - step.start < shortest_; }

 private:
  BallSeries series_;
  BallPhase* phase_ = nullptr;
  const BallContact* contact_ = nullptr;
  BallPhase::Motion start_ = {};
  double accuracy_ = 0, shortest_ = 0, first_cap_ = 0, place_ = 0;

  /// Largest place at which none of the last coefficients exceeds what it may.
  double step_length() const {
    const int terms = start_[BallMotion::root] == 0 ? last_onset_terms : last_terms;
    double step = infinity;
    for (int k = order(); k > order() - terms; --k) {
      double size = 0;
      for (int i = 0; i < BallMotion::states; ++i)
        size = std::max(size, std::abs(series_[i][k]) * contact_->weight[i]);
      if (size > 0) step = std::min(step, std::pow(series_share * force_share * accuracy_ / size, 1.0 / k));
    }
    return step;
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

  /// visit(guard, row, sign): it fires where the row times the sign falls through zero.
  template <class Visit>
  void each_guard(Visit&& visit) const {
    const auto& c = *contact_;
    visit(c.open, series_[BallMotion::root], 1.0);
    Row row;
    const auto with_noise = [&](int which, double noise) {
      const auto from = series_[which];
      std::copy(from.begin(), from.end(), row.begin());
      row[0] += noise;
      return std::span<const double>(row.data(), from.size());
    };
    const double turn = c.unloading ? -1 : 1;
    visit(c.turn, with_noise(BallMotion::approach, turn * c.rate_noise), turn);
    if (c.friction < 0) return;
    if (!sticks(c.grip)) {
      visit(c.friction, with_noise(BallMotion::watched, c.rate_noise), 1.0);
    } else if (c.grip == Grip::rigid_stick) {
      visit(c.friction, rigid_cap(row), 1.0);
    } else {
      visit(c.friction, spring_cap(row, 1), 1.0);
      visit(c.friction, spring_cap(row, -1), 1.0);
    }
  }

  /// Caps are allowed some noise: of a spring a share of what it is at first, as friction that starts at its
  /// cap leaves it; of a rigid stick what does not matter where forces fade.
  std::span<const double> spring_cap(Row& row, double sign) const {
    const auto force = series_[BallMotion::force], friction = series_[BallMotion::friction];
    for (std::size_t k = 0; k < force.size(); ++k)
      row[k] = contact_->parameter[BallMotion::coulomb] * force[k] - sign * friction[k];
    row[0] += contact_->force_share * first_cap_;
    return {row.data(), force.size()};
  }
  std::span<const double> rigid_cap(Row& row) const {
    const auto force = series_[BallMotion::force], left = series_[BallMotion::watched];
    const double allowed = 2 * contact_->force_noise * contact_->parameter[BallMotion::coulomb];
    for (std::size_t k = 0; k < force.size(); ++k) row[k] = left[k] + allowed * force[k];
    row[0] += contact_->faint_force * contact_->faint_force;
    return {row.data(), force.size()};
  }
};

BallTaylor::BallTaylor() : expansion_(std::make_unique<Expansion>()) {}
BallTaylor::~BallTaylor() = default;

Arrival BallTaylor::follow(const Problem& problem, BallPhase& phase, State x, const Request& request,
                           std::vector<Index>& fired) {
  expansion_->begin(problem, phase, request.accuracy);
  return follow_by_series(*expansion_, contact_limits, x, request, fired);
}

}  // namespace mariotte::flow
