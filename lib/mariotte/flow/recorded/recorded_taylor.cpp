#include "mariotte/flow/recorded/recorded_taylor.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mariotte/core/bracket.hpp"
#include "mariotte/flow/recorded/recorded_phase.hpp"
#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::flow {
namespace {

using series::TapeClock;
using series::TapeSeries;

/// Share of the accuracy that the last terms of a step may spend.
constexpr double share = 0.1;
/// Of the series in τ so many last coefficients may be incomplete.
constexpr int onset_loss = 4;
/// Last coefficients that bound a step: in τ only one in five differs from zero.
constexpr int last_terms = 2, last_onset_terms = 5;
/// So many steps, each shorter than this share of the natural time, lead towards a point that no series
/// passes: the slip of a spring in space where its contact opens, or a slip that comes to rest.
constexpr Index step_limit = 3000, stall_limit = 12;
constexpr double short_step = 1e-3;

int order_for(double accuracy) {
  if (accuracy > 1e-5) return 10;
  if (accuracy > 3e-8) return 14;
  return accuracy > 3e-12 ? 18 : 22;
}

bool is_finite(ConstState x) {
  return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
}

/// A series and how far it is followed.
struct Piece {
  const RecordedPhase& phase;
  const Recording& recording;
  const TapeSeries& series;

  double time(double place) const { return horner(series.time(), place); }
  /// The state at a place of the clock, from the state where the series begins.
  void state(double place, ConstState from, State x) const {
    std::copy(from.begin(), from.end(), x.begin());
    phase.fly_others(from, time(place), x);
    for (std::size_t i = 0; i < recording.state.size(); ++i)
      x[recording.component[i]] = horner(series.row(recording.state[i].place), place);
  }
  /// The place at which the clock shows t, if it shows `last` at `end`.
  double place(double t, double end, double last) const {
    if (!(t < last)) return end;
    return locate_sign_change([&](double at) { return time(at) - t; }, 0, -t, end, last - t, epsilon * end);
  }
};

class PolynomialStep final : public Step {
 public:
  explicit PolynomialStep(const Piece& piece) : piece_(piece) {}
  void at(double t, State x) const override {
    piece_.state(piece_.place(t - start, place_, end - start), before, x);
  }
  void inside(double fraction, State x) const override { piece_.state(fraction * place_, before, x); }
  /// On to the next step, of this duration and place of the clock.
  void go_on(double duration, double place, ConstState from, ConstState to) {
    start = std::exchange(end, end + duration);
    place_ = place;
    before = from;
    after = to;
  }

 private:
  const Piece& piece_;
  double place_ = 0;
};

/// Largest place at which none of the last `terms` of a component exceeds what it may.
double step_length(const Recording& recording, const TapeSeries& series, ConstState magnitude,
                   double accuracy, int order, int terms) {
  double step = infinity;
  for (std::size_t i = 0; i < recording.state.size(); ++i) {
    const auto row = series.row(recording.state[i].place);
    const double allowed = share * accuracy * magnitude[recording.component[i]];
    for (int k = order; k > order - terms; --k)
      if (const double size = std::abs(row[k]); size != 0)
        step = std::min(step, std::pow(allowed / size, 1.0 / k));
  }
  return step;
}

/// Where a step ends, and the guard that ends it.
struct End {
  double place;
  Index guard = -1;
  bool lands = false;  ///< where the contact of the clock opens
};

/// Bound of what the series of a guard leaves out at a place.
double tail(std::span<const double> row, double place) {
  const std::size_t last = row.size() - 1;
  return (std::abs(row[last]) * place + std::abs(row[last - 1])) *
         std::pow(place, static_cast<double>(last - 1));
}
/// How far a guard moves until a place, by its terms.
double change(std::span<const double> row, double place) {
  double sum = 0, power = place;
  for (std::size_t k = 1; k < row.size(); ++k, power *= place) sum += std::abs(row[k]) * power;
  return sum;
}
/// Whether what its series leaves out could hide the fall of a guard that ends above zero, or move its root.
bool is_doubtful(std::span<const double> row, std::optional<double> fired, double end) {
  const double moves = change(row, end);
  if (!(moves > 0) || fired == 0.0) return false;
  if (fired) return tail(row, *fired) > 1e-3 * change(row, *fired);
  return tail(row, end) > 1e-12 * moves && std::abs(horner(row, end)) < 100 * tail(row, end);
}

/// First place at which a guard falls through zero. One that starts behind zero is measured from there,
/// unless it goes on falling. Leading terms that are smaller than `rounding` of its change are zero.
std::optional<double> fall(std::span<const double> row, double sign, double end, double rounding) {
  std::array<double, TapeSeries::stride> c, term;
  double power = 1;
  for (std::size_t k = 0; k < row.size(); ++k, power *= end) {
    c[k] = sign * row[k];
    term[k] = std::abs(c[k] * power);
  }
  const double moves = change(row, end);
  if (!(moves > 0)) return std::nullopt;
  std::size_t k = 0;
  const auto is_zero = [&] { return term[k] <= rounding * moves || (k == 0 && c[0] < 0); };
  for (; k + 1 < row.size() && is_zero(); ++k) c[k] = 0;
  if (k > 0 && c[k] < 0) return 0.0;
  return first_fall({c.data(), row.size()}, end);
}

/// Steps end a little earlier where a guard is in doubt, and so the next one tells.
constexpr double shortened = 0.7;

End end_of_step(const Recording& recording, const TapeSeries& series, const TapeClock& clock, double reach,
                double rounding) {
  End end{reach};
  const auto look = [&](Index guard, int place, double sign) {
    const auto row = series.row(place);
    auto fired = fall(row, sign, end.place, rounding);
    while (is_doubtful(row, fired, end.place)) {
      end = {shortened * fired.value_or(end.place)};
      fired = fall(row, sign, end.place, rounding);
    }
    if (fired) end = {*fired, guard};
  };
  const bool lands = clock.kind == TapeClock::Kind::root;
  Index open = -1;
  for (const auto& one : recording.contact)
    if (lands && one.root == clock.root) look(open = one.open, one.root, 1);
  for (const auto& one : recording.guard)
    if (one.guard != open) look(one.guard, one.place, one.sign);
  end.lands = end.guard >= 0 && end.guard == open;
  return end;
}

}  // namespace

struct RecordedTaylor::Memory {
  Recording recording;
  TapeSeries series;
  Simultaneous simultaneous;
  std::vector<int> clocks, seen;
  std::vector<double> before, values, guards;

  void prepare() {
    seen.clear();
    clocks.clear();
    for (const auto& one : recording.guard) seen.push_back(one.place);
    for (const auto& one : recording.contact) {
      seen.push_back(one.depth);
      if (one.root >= 0) clocks.push_back(one.root);
    }
    series.prepare(recording.tape, recording.state, clocks, seen);
  }

  void load(ConstState x) {
    values.resize(recording.component.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = x[recording.component[i]];
  }

  /// The clock of the contact that is nearest in time to where its root is singular.
  TapeClock clock(bool first) {
    if (clocks.empty()) return {};
    const auto begins = [](const RecordedContact& one) { return one.begins && one.root >= 0; };
    if (first && std::any_of(recording.contact.begin(), recording.contact.end(), begins))
      return {.kind = TapeClock::Kind::onset};
    series.expand(values, 1, {});
    double nearest = infinity;
    TapeClock chosen{.kind = TapeClock::Kind::root, .root = clocks.front()};
    for (const auto& one : recording.contact) {
      const auto depth = series.row(one.depth);
      const double left = depth[0] / std::abs(depth[1]);
      if (one.root >= 0 && left < nearest) nearest = left, chosen.root = one.root;
    }
    return chosen;
  }

  /// A guard may be a product of what moves, and so less sharp than that: its root is found again from
  /// states.
  void sharpen(End& end, const Piece& piece, const Problem& problem, State x) {
    if (end.guard < 0 || end.lands || end.place == 0) return;
    const auto value = [&](double place) {
      piece.state(place, before, x);
      guards.resize(problem.guard_count());
      problem.guards(x, guards);
      return guards[end.guard];
    };
    double from = (1 - 1e-3) * end.place, at = end.place, past = value(from);
    for (int i = 0; i < 4; ++i) {
      const double now = value(at), slope = (now - past) / (at - from);
      const double next = at - now / slope;
      if (!(std::abs(next - at) < 1e-2 * end.place)) return;
      past = now, from = std::exchange(at, next);
      end.place = at;
      if (std::abs(at - from) <= 4 * epsilon * at) return;
    }
  }

  /// A contact that opens and is so shallow that it does nothing any more: the guard that opens it, after the
  /// time that it still takes. No series passes the end of some of them.
  std::optional<std::pair<Index, double>> opening() {
    series.expand(values, 1, {});
    for (const auto& one : recording.contact) {
      const auto depth = series.row(one.depth);
      if (depth[1] < 0 && depth[0] < one.negligible) return std::pair(one.open, -depth[0] / depth[1]);
    }
    return std::nullopt;
  }

  /// Along the tangent.
  void move_on(const Problem& problem, double duration, State x) {
    values.resize(x.size());
    problem.derivative(x, values);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] += duration * values[i];
  }

  static Arrival arrive(Outcome outcome, double time, Index steps, int order) {
    return {outcome, time, steps, steps * order, {}};
  }

  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) {
    const auto& phase = *problem.recorded();
    const double accuracy = resolving_accuracy(problem, request.accuracy, 64 * epsilon);
    const int usual = order_for(accuracy);
    if (!phase.record(x, request.accuracy, recording)) return arrive(Outcome::stiff, 0, 0, usual);
    prepare();
    const Piece piece{phase, recording, series};
    PolynomialStep step(piece);
    Index stalled = 0, count = 1;
    for (; count <= step_limit && stalled < stall_limit; ++count) {
      before.assign(x.begin(), x.end());
      load(x);
      const auto now = clock(count == 1);
      const bool onset = now.kind == TapeClock::Kind::onset;
      const int order = usual + (onset ? onset_loss : 0);
      series.expand(values, order, now);
      const double reach = step_length(recording, series, problem.magnitudes(), accuracy, usual,
                                       onset ? last_onset_terms : last_terms);
      if (!std::isfinite(reach)) return arrive(Outcome::stiff, step.end, count, order);
      End end = end_of_step(recording, series, now, reach, count == 1 ? accuracy : 0);
      sharpen(end, piece, problem, x);
      double duration = piece.time(end.place);
      const bool limited = step.end + duration >= request.limit;
      if (limited) {
        end = {piece.place(request.limit - step.end, end.place, duration)};
        duration = request.limit - step.end;
      }
      piece.state(end.place, before, x);
      if (!is_finite(x) || !std::isfinite(duration) || duration < 0) {
        std::ranges::copy(before, x.begin());
        return arrive(Outcome::stiff, step.end, count, order);
      }
      step.go_on(duration, end.place, before, x);
      if (limited) step.end = request.limit;
      if (request.observer) request.observer->observe(step);
      if (limited) return arrive(Outcome::limit, step.end, count, order);
      if (end.guard >= 0) {
        fired.push_back(end.guard);
        simultaneous.collect(problem, x, simultaneity_window(problem, request.accuracy), fired);
        return arrive(Outcome::guard, step.end, count, order);
      }
      stalled = duration < short_step * problem.time_scale() ? stalled + 1 : 0;
    }
    load(x);
    const auto opens = opening();
    if (!opens || step.end + opens->second > request.limit)
      return arrive(Outcome::stiff, step.end, count - 1, usual);
    move_on(problem, opens->second, x);
    fired.push_back(opens->first);
    return arrive(Outcome::guard, step.end + opens->second, count - 1, usual);
  }
};

RecordedTaylor::RecordedTaylor() : memory_(std::make_unique<Memory>()) {}
RecordedTaylor::~RecordedTaylor() = default;

Arrival RecordedTaylor::follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) {
  return memory_->follow(problem, x, request, fired);
}

}  // namespace mariotte::flow
