#include "mariotte/flow/taylor.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "mariotte/core/bracket.hpp"
#include "mariotte/flow/polynomial.hpp"
#include "mariotte/flow/simultaneous.hpp"
#include "mariotte/flow/taylor_start.hpp"
#include "mariotte/flow/taylor_window.hpp"

namespace mariotte::flow {

using namespace taylor;
using Role = SerialPhase::Role;

namespace {

constexpr Index step_limit = 10'000'000;
/// A contact whose remaining time is below so many steps is landed in its own clock.
const double landing_steps = getenv("LAND") ? atof(getenv("LAND")) : 2.5;
/// Share of the accuracy that one step may spend.
constexpr double local_share = 0.1;

struct Precision {
  double tolerance = 0;
  int order = 0;
  double small = 0;  ///< tolerance^{2/3}
};

/// Higher orders pay for themselves at tighter tolerances; measured by work_precision.
Precision precision(double accuracy) {
  if (getenv("ORD")) return {std::max(atof(getenv("SHARE")) * accuracy, 0.25 * epsilon), atoi(getenv("ORD")),0};
  const double tolerance = std::max(local_share * accuracy, 0.25 * epsilon);
  for (const auto& [above, order] : {std::pair{3e-6, 8}, {3e-8, 10}, {1e-9, 14}, {1e-12, 16}})
    if (accuracy > above) return {.tolerance = tolerance, .order = order};
  return {.tolerance = tolerance, .order = 18};
}

/// x^{1/n} to some per cent: the exponent bits divided by n.
double rough_root(double x, int n) {
  constexpr std::int64_t one = 0x3fef000000000000;
  return std::bit_cast<double>((std::bit_cast<std::int64_t>(x) - one) / n + one);
}

/// One series and how far it is followed.
struct Piece {
  Expansion* series = nullptr;  ///< null for the start series
  const Start* start = nullptr;
  int order = 0;
  int clock = Expansion::plain;
  double end = 0;

  void evaluate(double place, Values& values) const {
    series ? series->evaluate(place, values) : start->evaluate(place, values);
  }
  std::span<const double> coefficients(Quantity quantity, int lane, std::array<double, order_limit + 1>& c) const {
    series->coefficients(quantity, lane, c.data());
    return {c.data(), static_cast<std::size_t>(order) + 1};
  }
  /// The place that is reached at `time`, at most `end`.
  double place(double time, double last_time) const {
    if (!series || clock == Expansion::plain) return time;
    std::array<double, order_limit + 1> c;
    const auto t = coefficients(Quantity::time, clock, c);
    return locate_sign_change([&](double s) { return horner(t, s) - time; }, 0, -time, end, last_time - time,
                              epsilon * end);
  }
};

/// The guard that ends a piece.
struct Fall {
  Index guard = -1;
  int lane = -1;
  double place = infinity;
};

}  // namespace

namespace {

/// A step's polynomial for those who watch.
class SeriesStep final : public Step {
 public:
  SeriesStep(const Window& window, const Piece& piece, double last_time)
      : window_(window), piece_(piece), last_time_(last_time) {}
  void at(double time, State x) const override {
    Values values;
    piece_.evaluate(piece_.place(time - start, last_time_), values);
    Window inside = window_;
    taylor::advance(inside, values);
    write(inside, x);
  }

 private:
  const Window& window_;
  const Piece& piece_;
  double last_time_;
};

}  // namespace

struct Taylor::Memory {
  Window window;
  Values values;
  Start start;
  std::array<std::unique_ptr<Expansion>, 5> expansions;
  Simultaneous simultaneous;
  std::vector<double> before, after;
  Precision precision;
  double last_time;  ///< length of the step before
  bool watched_clock = false;

  Expansion& expansion() {
    const int lanes = window.lanes.count;
    const std::size_t size = lanes <= 16 ? (lanes - 1) / 4 : 4;
    auto& chosen = expansions[size];
    if (!chosen) chosen = make_expansion(lanes);
    return *chosen;
  }

  bool struck(int lane) const {
    return window.contact(lane).role == Role::closed && window.lanes.indentation[lane] == 0 &&
           window.lanes.rate[lane] > 0;
  }

  /// The start series, if all contacts that carry force are undamped Hertz contacts which start undeformed.
  bool starts(std::array<Start::Part, lane_limit>& part) const {
    const auto& l = window.lanes;
    if (l.damped) return false;
    int count = 0, pressed = 0;
    for (int j = 0; j < l.count; ++j) {
      part[j] = Start::Part::passive;
      if (l.drive[j] != 0) return false;
      if (window.contact(j).role == Role::open) continue;
      if (l.indentation[j] != 0 || !window.is_sharp(j)) return false;
      if (struck(j)) {
        part[j] = Start::Part::struck;
        ++count;
      }
    }
    for (int j = 0; j < l.count; ++j) {
      if (window.contact(j).role != Role::touching) continue;
      const bool beside = (j > 0 && part[j - 1] == Start::Part::struck) ||
                          (j + 1 < l.count && part[j + 1] == Start::Part::struck);
      if (!beside || l.rate[j] != 0) continue;
      part[j] = Start::Part::pressed;
      ++pressed;
    }
    return count > 1 || (count == 1 && pressed > 0);
  }

  std::optional<Piece> start_piece() {
    std::array<Start::Part, lane_limit> part;
    if (!starts(part)) return std::nullopt;
    Piece piece{.start = &start, .order = precision.order};
    for (int j = 0; j < window.lanes.count; ++j) window.lanes.push[j] = part[j] != Start::Part::passive;
    piece.end = 0.9 * start.expand(window.lanes, part.data(), precision.order, precision.tolerance);
    for (int tries = 0; tries < 60; ++tries, piece.end *= 0.5) {
      piece.evaluate(piece.end, values);
      const bool sure = std::all_of(values.margin, values.margin + window.lanes.count,
                                    [](double margin) { return margin >= 0; });
      if (sure) return piece;
    }
    return std::nullopt;
  }

  /// The lane whose separation, or onset, limits a series in time.
  int choose_clock() const {
    const auto& l = window.lanes;
    int clock = Expansion::plain;
    double soonest = landing_steps * last_time;
    for (int j = 0; j < l.count; ++j) {
      if (!window.is_sharp(j) || !window.pushes(j)) continue;
      if (struck(j)) return j;
      if (window.contact(j).role != Role::closed) continue;
      if (!(l.rate[j] < 0) || !(l.indentation[j] < -soonest * l.rate[j])) continue;
      soonest = -l.indentation[j] / l.rate[j];
      clock = j;
    }
    return clock;
  }

  Piece series_piece() {
    auto& l = window.lanes;
    Piece piece{.series = &expansion(), .order = precision.order, .clock = choose_clock()};
    for (int j = 0; j < l.count; ++j)
      l.push[j] = window.pushes(j) && (j == piece.clock || l.indentation[j] > window.wake[j]);
    piece.series->expand(l, piece.order, piece.clock);
    // Right after an onset only every fifth coefficient differs from zero.
    const bool fresh = piece.clock != Expansion::plain && l.indentation[piece.clock] == 0;
    piece.end = infinity;
    for (int k = piece.order; k > piece.order - (fresh ? 5 : 2); --k)
      piece.end = std::min(piece.end, rough_root(precision.tolerance / std::max(piece.series->size(k), 1e-300), k));
    watched_clock = piece.clock != Expansion::plain && l.side[piece.clock] > 0;
    if (watched_clock) l.side[piece.clock] = 0;  // looked at through √δ instead
    piece.evaluate(piece.end, values);
    return piece;
  }

  void evaluate(Piece& piece, double place) {
    piece.end = place;
    piece.evaluate(place, values);
  }

  /// End the piece where a contact whose force is left out has reached the depth at which it wakes.
  void wake_gently(Piece& piece) {
    const auto& l = window.lanes;
    for (int j = 0; j < l.count; ++j) {
      if (!window.pushes(j) || l.push[j] > 0) continue;
      for (int tries = 0; tries < 60 && values.indentation[j] > 3 * window.wake[j]; ++tries) {
        const double depth = std::max(l.indentation[j], 0.0), goal = 2 * window.wake[j];
        // Depths grow with a high power of time: the secant of the logarithm is enough.
        const double share = depth > 0 ? (goal - depth) / (values.indentation[j] - depth) : 0;
        const double power = rough_root(goal / values.indentation[j], 4);
        evaluate(piece, piece.end * std::clamp(std::max(share, power), 0.1, 0.98));
      }
    }
  }

  /// End the piece after `time` at the latest; true if it does.
  bool stay_within(Piece& piece, double time) {
    if (values.time < time) return false;
    evaluate(piece, piece.place(time, values.time));
    values.time = time;
    return true;
  }

  void search(const Piece& piece, Quantity quantity, int lane, double side, double level, Index guard,
              Fall& fall) const {
    std::array<double, order_limit + 1> c;
    piece.coefficients(quantity, lane, c);
    for (int k = 0; k <= piece.order; ++k) c[k] *= side;
    c[0] += level;
    const auto place =
        flow::first_fall({c.data(), static_cast<std::size_t>(piece.order) + 1}, std::min(piece.end, fall.place));
    if (place && *place < fall.place) fall = {guard, lane, *place};
  }

  /// The first guard that fires within the piece.
  Fall first_fall(const Piece& piece) const {
    Fall fall;
    if (!piece.series) return fall;  // chosen so short that none does
    const auto& l = window.lanes;
    for (int j = 0; j < l.count; ++j) {
      if (l.side[j] != 0 && values.margin[j] < 0)
        search(piece, Quantity::indentation, j, l.side[j], l.level[j], window.contact(j).guard, fall);
      if (l.damped && l.load_side[j] != 0 && values.load_margin[j] < 0)
        search(piece, Quantity::load, j, l.load_side[j], 0, window.contact(j).load_guard, fall);
    }
    if (watched_clock)
      search(piece, Quantity::clock, piece.clock, 1, 0, window.contact(piece.clock).guard, fall);
    return fall;
  }

  void show(const Piece& piece, Watcher& watcher) {
    SeriesStep step(window, piece, values.time);
    before.resize(window.x.size());
    after.resize(window.x.size());
    write(window, before);
    Window next = window;
    taylor::advance(next, values);
    write(next, after);
    step.start = window.time;
    step.end = next.time;
    step.before = before;
    step.after = after;
    watcher.watch(step);
  }

  /// What fired stands exactly at its level.
  void settle(const Piece& piece, const Fall& fall) {
    auto& l = window.lanes;
    if (watched_clock) watch(window, piece.clock);
    watched_clock = false;
    if (fall.lane >= 0 && fall.guard == window.contact(fall.lane).guard)
      l.indentation[fall.lane] = l.side[fall.lane] < 0 ? l.level[fall.lane] : 0;
  }

  bool is_finite() const {
    return std::all_of(window.velocity, window.velocity + window.lanes.count + 1,
                       [](double velocity) { return std::isfinite(velocity); });
  }

  /// A closed contact that is so shallow, and parts so slowly, that its end would be an event made of noise.
  bool has_faded() const {
    const auto& l = window.lanes;
    for (int j = 0; j < l.count; ++j)
      if (window.contact(j).role == Role::closed && l.indentation[j] < window.contact(j).shallow &&
          l.rate[j] <= 0 && l.rate[j] >= -window.phase->slow)
        return true;
    return false;
  }

  /// Tell the problem when a touching contact has left the noise.
  Accepted accept(Problem& problem) {
    const auto& l = window.lanes;
    bool news = false;
    for (int j = 0; j < l.count; ++j)
      news |= window.contact(j).role == Role::touching && l.indentation[j] > 2 * window.contact(j).shallow;
    if (!news) return Accepted::unchanged;
    after.resize(window.x.size());
    write(window, after);
    const auto accepted = problem.accept(after);
    for (int j = 0; j < l.count; ++j) watch(window, j);
    return accepted;
  }

  /// A contact at the edge is about to push on a body outside.
  bool outgrown() const {
    const int last = window.lanes.count - 1;
    const auto edge = [&](int j, bool at_end) {
      return !at_end && window.pushes(j) && window.lanes.indentation[j] > window.wake[j];
    };
    return edge(0, window.first == 0) ||
           edge(last, window.first + last + 1 == static_cast<Index>(window.phase->contact.size()));
  }
};

Taylor::Taylor() : memory_(std::make_unique<Memory>()) {}
Taylor::~Taylor() = default;

bool Taylor::admits(const Problem& problem) {
  const auto* phase = problem.serial();
  if (!phase) return false;
  const auto& contacts = phase->contact;
  const auto idle = [](const SerialPhase::Contact& c) { return c.role == Role::open; };
  const auto first = std::find_if_not(contacts.begin(), contacts.end(), idle);
  const auto last = std::find_if_not(contacts.rbegin(), contacts.rend(), idle).base();
  return last - first + 2 <= lane_limit && std::all_of(first, last, [&](const SerialPhase::Contact& c) {
           return idle(c) || c.exponent == 1 || c.exponent == 1.5;
         });
}

Arrival Taylor::follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) {
  auto& m = *memory_;
  auto& w = m.window;
  m.precision = precision(request.accuracy);
  m.last_time = 0.1 * problem.time_scale();
  Arrival arrival{.outcome = Outcome::guard, .message = {}};
  const auto stop = [&](Outcome outcome, std::string message = {}) {
    write(w, x);
    arrival.outcome = outcome;
    arrival.duration = w.time;
    arrival.message = std::move(message);
    return arrival;
  };
  m.precision.small = std::cbrt(m.precision.tolerance * m.precision.tolerance);
  if (!place(w, *problem.serial(), x, 0, m.precision.small))
    return {.outcome = Outcome::failed, .message = "more contacts than the series has lanes"};
  bool first = true;
  while (arrival.steps < step_limit) {
    auto piece = first ? m.start_piece() : std::nullopt;
    if (!piece) piece = m.series_piece();
    if (!(piece->end > 0)) return stop(Outcome::failed, "the series does not converge");
    m.wake_gently(*piece);
    const bool limited = m.stay_within(*piece, std::min(request.limit, w.outside_time) - w.time);
    const auto fall = m.first_fall(*piece);
    if (fall.guard >= 0) m.evaluate(*piece, fall.place);
    m.last_time = m.values.time;
    ++arrival.steps;
    ++arrival.rhs;
    if (request.watcher) m.show(*piece, *request.watcher);
    taylor::advance(w, m.values);
    m.settle(*piece, fall);
    if (!m.is_finite()) return stop(Outcome::failed, "a velocity is not finite");
    first = false;

    if (fall.guard >= 0) {
      fired.push_back(fall.guard);
    } else if (limited) {
      if (w.time >= request.limit) return stop(Outcome::limit);
      fired.push_back(w.phase->contact[w.outside].guard);
    }
    if (!fired.empty()) {
      stop(Outcome::guard);
      m.simultaneous.collect(problem, x, simultaneity_window(problem, request.accuracy), fired);
      return arrival;
    }
    if (m.has_faded() || m.accept(problem) == Accepted::ended) return stop(Outcome::guard);
    if (m.outgrown()) {
      write(w, x);
      if (!place(w, *problem.serial(), x, w.time, m.precision.small)) return stop(Outcome::guard);
    }
  }
  return stop(Outcome::failed, "no guard fired within the step limit");
}

}  // namespace mariotte::flow
