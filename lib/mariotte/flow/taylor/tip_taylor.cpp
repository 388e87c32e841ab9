#include <tuple>
#include <utility>

#include "mariotte/core/bracket.hpp"
#include "mariotte/flow/roots/rough_root.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"
#include "mariotte/flow/series_flow.hpp"
#include "mariotte/flow/taylor/tip_motion.hpp"

namespace mariotte::flow {
namespace {

/// A slip that friction holds down to a small, turning rest is stiff: |u| bounds the steps. So is a tip that
/// creeps in its well by strong damping. What needs more steps, or has no finite series, is left to BDF.
constexpr SeriesLimits limits{.steps = 5000, .stalled = 200};

/// Where a tip that sticks breaks loose while its force changes sign, it slides for a moment before and a
/// moment after. What may be such a moment is expanded so far first, and no further if that shows its end.
constexpr int brief_order = 8;
/// Share of the incident speed.
constexpr double slow_slip = 0.1;

std::span<const double> terms(const PowerSeries& row, int order) {
  return {row.data(), static_cast<std::size_t>(order) + 1};
}

/// First τ at which a guard falls through zero. What is zero to `rounding` at the start does not fire unless
/// it falls from there; what is below fires at once.
std::optional<double> fall(const PowerSeries& row, int order, double end, double rounding) {
  int k = std::abs(row[0]) <= rounding ? 1 : 0;
  while (k < order && row[k] == 0) ++k;
  if (row[k] < 0) return 0.0;
  return first_fall(terms(row, order).subspan(k), end);
}

/// Where w, negative or rising at the start, has been positive and falls through zero again. Where it may
/// do so after rising within the step, for it does not only rise, the step is cut at the rise and the next
/// one decides.
SeriesEnd turn_back(const PowerSeries& w, int order, double tau, double rounding, Index guard) {
  if (w[0] > rounding || (w[0] >= -rounding && w[1] > 0)) {
    const auto back = fall(w, order, tau, rounding);
    return back ? SeriesEnd{*back, guard} : SeriesEnd{tau};
  }
  PowerSeries mirrored;
  for (int k = 0; k <= order; ++k) mirrored[k] = -w[k];
  if (falls(terms(mirrored, order), tau)) return {tau};
  const auto rise = first_fall(terms(mirrored, order), tau);
  return rise && *rise > 0 && *rise < tau ? SeriesEnd{*rise} : SeriesEnd{tau};
}

/// A force that starts within its error has no sign yet: it creeps, or has just changed sign. It may go as
/// far beyond zero again until it has left.
template <class Series>
void doubt_force(TipPhase& phase, const Series& series, double error, bool first) {
  const double force = detail::signed_pressure(series, phase, 0) / detail::pressure_size(series, phase);
  const bool doubted = first || phase.force_doubt > 0;
  phase.force_doubt = doubted && force <= error ? 2 * error : 0;
}

/// A guard that has just fired is zero up to the accuracy of the step that led there.
template <class Series>
SeriesEnd end_of_step(const Series& series, const TipPhase& phase, int order, double tau, double rounding) {
  SeriesEnd end{tau};
  each_guard(series, phase, order, [&](Index guard, const PowerSeries& row, double size) {
    const auto fired = fall(row, order, end.place, rounding * size);
    if (fired && (end.guard < 0 || *fired < end.place)) end = {*fired, guard};
  });
  if (phase.turn_back < 0) return end;
  const auto turn =
      turn_back(series[series.w], order, end.place, 64 * epsilon * phase.speed, phase.turn_back);
  return turn.place < end.place ? turn : end;
}

/// How far rounding lets a series of friction reach, if it divides by the size of a slip in space.
/// Coefficients of 1/|u| grow like R⁻ᵏ, with R the way to where a slip as it is now would vanish. They cancel
/// where the slip does not turn; what rounding leaves of them is any number, also zero.
double reach_of_friction(const SpatialSeries& series, const TipPhase& phase, double accuracy, int order) {
  if (phase.friction == 0 || phase.sticking || phase.slip != TipPhase::Slip::moving) return infinity;
  const auto squared = [&](int k) {
    const double along = series[series.slip][k], across = series[series.slip + 1][k];
    return along * along + across * across;
  };
  constexpr double tiny = 1e-300;
  const double scale = 1 / std::max(squared(0), tiny);
  double inverse = 0;
  for (int k = 1; k <= order; ++k)
    inverse = std::max(inverse, rough_root(std::max(scale * squared(k), tiny), 2 * k));
  return rough_root(series_share * accuracy / epsilon, order) / inverse;
}
/// Others do not divide by it.
template <class Series>
double reach_of_friction(const Series&, const TipPhase&, double, int) {
  return infinity;
}

/// From the last coefficients. The squares in the cone of a tip that sticks in space lose more by being cut
/// off: half the step makes up for it.
template <class Series>
double step_length(const Series& series, const TipPhase& phase, double accuracy, int order) {
  const double last =
      reach_of_last(terms(series[series.time], order), order, series_share * accuracy * phase.speed,
                    [&](int k) { return coefficient(series, phase, k); });
  const double step = std::min(last, reach_of_friction(series, phase, accuracy, order));
  const bool squares = phase.cone >= 0 && phase.motion == TipPhase::Motion::spatial;
  return squares ? 0.5 * step : step;
}

/// Where a tip can rest within a step: it moves slowly enough, and is not so deep that its energy
/// 2/5 k δ^{5/2} − 2/3 b δ^{3/2} − W δ is positive, with the weight W that holds a body which cannot swing.
struct SlowPart {
  double first, last;
};

template <class Series>
std::optional<SlowPart> slow_part(const Series& series, const TipPhase& phase, int order, double end) {
  const double weight = phase.held_weight;
  const auto in_well = [&](double s) {
    return s * (0.4 * phase.stiffness * s * s - 2.0 / 3.0 * phase.adhesion) < weight;
  };
  if (phase.rest < 0 ||
      !(in_well(series[series.s][0]) || in_well(horner(terms(series[series.s], order), end))))
    return {};
  const double sign = series[series.w][0] < 0 ? -1 : 1;
  PowerSeries excess;  // of the speed
  for (int k = 0; k <= order; ++k) excess[k] = sign * series[series.w][k];
  excess[0] -= phase.rest_speed;
  const auto first = excess[0] <= 0 ? 0 : first_fall(terms(excess, order), end);
  if (!first) return {};
  const auto back = [&](double tau) {  // positive until it is as fast again the other way
    return horner(terms(excess, order), tau) + 2 * phase.rest_speed;
  };
  const double left = back(end);
  const double last = left < 0 ? locate_sign_change(back, *first, back(*first), end, left, 1e-6 * end) : end;
  return SlowPart{*first, last};
}

/// The series of one motion, as `follow_by_series` drives it.
template <class Series>
class TipMotionSeries final {
 public:
  std::vector<double> before;

  void begin(const Problem& problem, double asked) {
    problem_ = &problem;
    phase_ = *problem.tip();
    accuracy_ = resolving_accuracy(problem, asked, 64 * epsilon);
    full_order_ = series_order(accuracy_);
    guards_.resize(problem.guard_count());
  }

  int order() const { return full_order_; }
  std::span<const double> time() const { return terms(series_[series_.time], order_); }
  bool is_stalled(const Step& step) const { return step.end - step.start <= 2 * epsilon * step.end; }

  double expand(ConstState x, bool first) {
    if (!first) phase_.slip = TipPhase::Slip::moving;
    load(series_, phase_, x);
    order_ = 0;
    if (first && may_be_brief()) {
      const double reach = reach_of(std::min(brief_order, full_order_));
      if (any_guard([&](Index, const PowerSeries& row) { return horner(terms(row, order_), reach) < 0; }))
        return reach;
    }
    return reach_of(full_order_);
  }

  SeriesEnd end(double reach, bool first, State x) {
    doubt_force(phase_, series_, accuracy_, first);
    return rest_or(end_of_step(series_, phase_, order_, reach, first ? accuracy_ : 0), x);
  }

  void state(double place, ConstState from, State x) const { store(series_, phase_, place, order_, from, x); }

  void fire(Index guard, State x, std::vector<Index>& fired) const {
    if (guard == phase_.separation) x[phase_.place.gap[phase_.tip]] = 0;
    fired.push_back(guard);
  }

 private:
  Series series_;
  const Problem* problem_ = nullptr;
  TipPhase phase_;
  double accuracy_ = 0;
  int order_ = 0, full_order_ = 0;
  std::vector<double> guards_;

  void expand_to(int order) { series_.expand(phase_, order, std::exchange(order_, order)); }
  /// Expand up to this order: how far the series is good enough.
  double reach_of(int order) {
    expand_to(order);
    return step_length(series_, phase_, accuracy_, order_);
  }

  template <class Is>
  bool any_guard(Is&& is) {
    bool any = false;
    each_guard(series_, phase_, order_,
               [&](Index guard, const PowerSeries& row, double) { any = any || is(guard, row); });
    return any;
  }

  /// It has just broken loose, or slips so slowly that it may soon hold again.
  bool may_be_brief() {
    if (phase_.stop < 0) return false;
    if (phase_.slip != TipPhase::Slip::moving) return phase_.slip == TipPhase::Slip::breaking;
    expand_to(1);
    return any_guard([&](Index guard, const PowerSeries& row) {
      return guard == phase_.stop && row[0] < slow_slip * phase_.speed;
    });
  }

  double unrest(double place, State x) {
    state(place, before, x);
    problem_->guards(x, guards_);
    return guards_[phase_.rest];
  }

  /// The first place of rest in the step that ends at `end`, or that end. Rest is no series, it takes the
  /// energy: it is looked for while the tip is slow, at the beginning of that above all.
  SeriesEnd rest_or(SeriesEnd end, State x) {
    constexpr int pieces = 8;
    constexpr double inside = 1e-6;  // where the tip has just become slow it may be too fast by rounding
    const auto slow = slow_part(series_, phase_, order_, end.place);
    double last = 0, from = 0;
    for (int k = 0; slow && k <= pieces; ++k) {
      const double share = k == 0 ? inside : static_cast<double>(k) / pieces;
      const double place = slow->first + (slow->last - slow->first) * share, now = unrest(place, x);
      if (now <= 0 && k == 0) return {slow->first, phase_.rest};
      if (now <= 0)
        return {locate_sign_change([&](double at) { return unrest(at, x); }, from, last, place, now,
                                   epsilon * place),
                phase_.rest};
      last = now, from = place;
    }
    return end;
  }
};

class TipTaylor final : public Flow {
 public:
  bool admits(const Problem& problem) override { return problem.tip() != nullptr; }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  TipMotionSeries<NormalSeries> normal_;
  TipMotionSeries<PlanarSeries> planar_;
  TipMotionSeries<SpatialSeries> spatial_;
};

Arrival TipTaylor::follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) {
  const auto motion = problem.tip()->motion;
  const auto by = [&](auto& expansion) {
    expansion.begin(problem, request.accuracy);
    return follow_by_series(expansion, limits, x, request, fired);
  };
  auto arrival = motion == TipPhase::Motion::normal   ? by(normal_)
                 : motion == TipPhase::Motion::planar ? by(planar_)
                                                      : by(spatial_);
  if (arrival.outcome == Outcome::stiff)
    problem.accept(x);  // the next flow starts from where the slip is now
  return arrival;
}

}  // namespace

std::unique_ptr<Flow> make_tip_flow() {
  return std::make_unique<TipTaylor>();
}

}  // namespace mariotte::flow
