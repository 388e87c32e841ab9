#include "mariotte/flow/taylor/tip_taylor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "mariotte/core/bracket.hpp"
#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"
#include "mariotte/flow/taylor/tip_motion.hpp"

namespace mariotte::flow {
namespace {

/// Share of the accuracy that the last terms of a step may spend: an impact takes about ten steps.
constexpr double share = 0.1;
/// A slip that friction holds down to a small, turning rest is stiff: |u| bounds the steps. So is a tip that
/// creeps in its well by strong damping. What needs more steps, or has no finite series, is left to BDF.
constexpr Index step_limit = 5000, stall_limit = 200;

/// Order that costs least at an accuracy; measured on the reference bodies.
int order_for(double accuracy) {
  if (accuracy > 1e-5) return 10;
  if (accuracy > 3e-8) return 14;
  return accuracy > 3e-12 ? 18 : 22;
}

std::span<const double> terms(const PowerSeries& row, int order) {
  return {row.data(), static_cast<std::size_t>(order) + 1};
}

/// τ at which the clock shows t; the clock never goes back.
double clock_inverse(const PowerSeries& time, double t, double end, int order) {
  double low = 0, high = end, tau = end;
  for (int i = 0; i < 100; ++i) {
    double value = 0, slope = 0;
    for (int k = order; k >= 0; --k) {
      slope = slope * tau + value;
      value = value * tau + time[k];
    }
    (value > t ? high : low) = tau;
    double next = tau - (value - t) / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - tau) <= 4 * epsilon * end) return next;
    tau = next;
  }
  return tau;
}

template <class Series>
class SeriesStep final : public Step {
 public:
  SeriesStep(const Series& series, const TipPhase& phase, int order)
      : series_(series), phase_(phase), order_(order) {}
  void at(double time, State x) const override {
    store(series_, phase_, clock_inverse(series_[series_.time], time - start, tau_, order_), order_, before,
          x);
  }
  void inside(double place, State x) const override {
    store(series_, phase_, place * tau_, order_, before, x);
  }
  /// On to the next step, of this duration and clock.
  void go_on(double duration, double clock, ConstState from, ConstState to) {
    start = std::exchange(end, end + duration);
    tau_ = clock;
    before = from;
    after = to;
  }

 private:
  double tau_ = 0;  ///< at the end
  const Series& series_;
  const TipPhase& phase_;
  int order_;
};

/// Where a step ends, and the guard that ends it.
struct End {
  double tau;
  Index guard = -1;
};

/// First τ at which a guard falls through zero. What is zero to `rounding` at the start does not fire unless
/// it falls from there; what is below fires at once.
std::optional<double> fall(PowerSeries row, int order, double end, double rounding) {
  if (std::abs(row[0]) <= rounding) row[0] = 0;
  int k = 0;
  while (k < order && row[k] == 0) ++k;
  if (row[k] < 0) return 0.0;
  return first_fall(terms(row, order), end);
}

/// Where w, negative or rising at the start, has been positive and falls through zero again. Where it may
/// do so after rising within the step, for it does not only rise, the step is cut at the rise and the next
/// one decides.
End turn_back(const PowerSeries& w, int order, double tau, double rounding, Index guard) {
  if (w[0] > rounding || (w[0] >= -rounding && w[1] > 0)) {
    const auto back = fall(w, order, tau, rounding);
    return back ? End{*back, guard} : End{tau};
  }
  PowerSeries mirrored;
  for (int k = 0; k <= order; ++k) mirrored[k] = -w[k];
  if (falls(terms(mirrored, order), tau)) return {tau};
  const auto rise = first_fall(terms(mirrored, order), tau);
  return rise && *rise > 0 && *rise < tau ? End{*rise} : End{tau};
}

/// A force that starts within its error has no sign yet: it creeps, or has just changed sign. It may go as
/// far beyond zero again until it has left.
template <class Series>
void doubt_force(TipPhase& phase, const Series& series, double error, bool first) {
  const double force = detail::signed_pressure(series, phase, 0) / detail::pressure_size(series, phase);
  const bool doubted = first || phase.force_doubt > 0;
  phase.force_doubt = doubted && force <= error ? 2 * error : 0;
}

bool is_finite(ConstState x) {
  return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
}

/// A guard that has just fired is zero up to the accuracy of the step that led there.
template <class Series>
End end_of_step(const Series& series, const TipPhase& phase, int order, double tau, double rounding) {
  End end{tau};
  each_guard(series, phase, order, [&](Index guard, const PowerSeries& row, double size) {
    const auto fired = fall(row, order, end.tau, rounding * size);
    if (fired && (end.guard < 0 || *fired < end.tau)) end = {*fired, guard};
  });
  if (phase.turn_back < 0) return end;
  const auto turn = turn_back(series[series.w], order, end.tau, 64 * epsilon * phase.speed, phase.turn_back);
  return turn.tau < end.tau ? turn : end;
}

/// From the last coefficients; where the tip touches, from as many as may vanish between two that do not. The
/// squares in the cone of a tip that sticks in space lose more by being cut off: half the step makes up for
/// it.
template <class Series>
double step_length(const Series& series, const TipPhase& phase, double accuracy, int order) {
  const double allowed = share * accuracy * phase.speed;
  const int last = series[series.s][0] == 0 ? 5 : 2;
  double step = infinity;
  for (int k = order; k > order - last; --k)
    if (const double c = coefficient(series, phase, k); c != 0)
      step = std::min(step, std::pow(allowed / c, 1.0 / k));
  const bool squares = phase.cone >= 0 && phase.motion == TipPhase::Motion::spatial;
  return squares ? 0.5 * step : step;
}

/// Where a tip can rest within a step: it moves slowly enough, and is not so deep that its elastic energy
/// 2/5 k δ^{5/2} − 2/3 b δ^{3/2} is positive, δ > 5/3 b/k.
struct SlowPart {
  double first, last;
};

template <class Series>
std::optional<SlowPart> slow_part(const Series& series, const TipPhase& phase, int order, double end) {
  const auto in_well = [&](double s) { return 0.4 * phase.stiffness * s * s < 2.0 / 3.0 * phase.adhesion; };
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

}  // namespace

struct TipTaylor::Memory {
  NormalSeries normal;
  PlanarSeries planar;
  SpatialSeries spatial;
  std::vector<double> before, guards;

  /// The first place of rest in the step that ends at `end`, or that end; x is the state there. Rest is no
  /// series, it takes the energy: it is looked for while the tip is slow, at the beginning of that above all.
  template <class Series>
  End rest_or(End end, const Series& series, const TipPhase& phase, int order, const Problem& problem,
              State x) {
    constexpr int pieces = 8;
    constexpr double inside = 1e-6;  // where the tip has just become slow it may be too fast by rounding
    const auto unrest = [&](double tau) {
      store(series, phase, tau, order, before, x);
      problem.guards(x, guards);
      return guards[phase.rest];
    };
    guards.resize(problem.guard_count());
    const auto slow = slow_part(series, phase, order, end.tau);
    double last = 0, from = 0;
    for (int k = 0; slow && k <= pieces; ++k) {
      const double place = k == 0 ? inside : static_cast<double>(k) / pieces;
      const double tau = slow->first + (slow->last - slow->first) * place, now = unrest(tau);
      if (now <= 0) {
        end = {k == 0 ? slow->first : locate_sign_change(unrest, from, last, tau, now, epsilon * tau),
               phase.rest};
        break;
      }
      last = now, from = tau;
    }
    store(series, phase, end.tau, order, before, x);
    return end;
  }

  template <class Series>
  Arrival follow(Series& series, Problem& problem, State x, const Request& request,
                 std::vector<Index>& fired) {
    TipPhase phase = *problem.tip();
    const double accuracy = resolving_accuracy(problem, request.accuracy, 64 * epsilon);
    const int order = order_for(accuracy);
    SeriesStep<Series> step(series, phase, order);
    Index stalled = 0;
    Index count = 1;
    for (; count <= step_limit && stalled < stall_limit; ++count) {
      before.assign(x.begin(), x.end());
      load(series, phase, x);
      series.expand(phase, order);
      const double reach = step_length(series, phase, accuracy, order);
      if (!std::isfinite(reach)) return arrive(Outcome::stiff, step.end, count, order);
      doubt_force(phase, series, accuracy, count == 1);
      End end = end_of_step(series, phase, order, reach, count == 1 ? accuracy : 0);
      end = rest_or(end, series, phase, order, problem, x);
      double duration = horner(terms(series[series.time], order), end.tau);
      const bool limited = step.end + duration >= request.limit;
      if (limited) {
        duration = request.limit - step.end;
        end = {clock_inverse(series[series.time], duration, end.tau, order)};
        store(series, phase, end.tau, order, before, x);
      }
      if (!is_finite(x) || !std::isfinite(duration)) {
        std::ranges::copy(before, x.begin());
        return arrive(Outcome::stiff, step.end, count, order);
      }
      if (end.guard == phase.separation) x[phase.place.gap[phase.tip]] = 0;
      step.go_on(duration, end.tau, before, x);
      if (limited) step.end = request.limit;
      if (request.observer) request.observer->observe(step);
      if (end.guard >= 0) fired.push_back(end.guard);
      if (limited || end.guard >= 0)
        return arrive(limited ? Outcome::limit : Outcome::guard, step.end, count, order);
      phase.slip = TipPhase::Slip::moving;
      stalled += step.end - step.start <= 2 * epsilon * step.end;
    }
    return arrive(Outcome::stiff, step.end, count - 1, order);
  }

  static Arrival arrive(Outcome outcome, double time, Index steps, int order) {
    return {outcome, time, steps, steps * order, {}};
  }
};

TipTaylor::TipTaylor() : memory_(std::make_unique<Memory>()) {}
TipTaylor::~TipTaylor() = default;

bool TipTaylor::admits(const Problem& problem) {
  return problem.tip() != nullptr;
}

Arrival TipTaylor::follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) {
  const auto motion = problem.tip()->motion;
  const auto by = [&](auto& series) { return memory_->follow(series, problem, x, request, fired); };
  auto arrival = motion == TipPhase::Motion::normal   ? by(memory_->normal)
                 : motion == TipPhase::Motion::planar ? by(memory_->planar)
                                                      : by(memory_->spatial);
  if (arrival.outcome == Outcome::stiff)
    problem.accept(x);  // the next flow starts from where the slip is now
  return arrival;
}

}  // namespace mariotte::flow
