#include "triplet.hpp"

#include <algorithm>
#include <utility>

#include "extrapolation.hpp"
#include "series.hpp"

namespace mariotte::reference {
namespace {

enum class Mode { open, carrying, slack };

// x₁ or g₁, x₂ or g₂, v₁, v₂, v₃, t
using State = std::array<Real, 6>;
constexpr std::size_t velocity_at = 2, time_at = 5;

constexpr Real allowed = 1e-25L;  // difference of two columns per step; the error is far below
constexpr Real longest_step = 2;  // on the stretched clock, where a contact takes a few units
constexpr Real first_step = 0.1L;
constexpr Real located = 1e-29L;     // of a step
constexpr Real negligible = 1e-24L;  // a contact this shallow that parts has parted
constexpr Real start_share = 0.05L;  // of the natural time: there the series has converged

struct Simulation {
  const Triplet& triplet;
  std::array<Mode, 2> mode{};
  State state{};
  Outcome outcome{};

  bool carries(std::size_t j) const { return mode[j] == Mode::carrying; }
  static Real rate(const State& y, std::size_t j) { return y[velocity_at + j] - y[velocity_at + j + 1]; }

  /// dy/ds.
  State derivative(const State& y) const {
    const bool both = carries(0) && carries(1);
    const Real clock = both ? y[0] * y[1] / (y[0] + y[1]) : carries(0) ? y[0] : y[1];
    std::array<Real, 2> force{};
    State d{};
    for (std::size_t j = 0; j < 2; ++j) {
      const Real w = rate(y, j);
      if (carries(j)) {
        d[j] = w / 2 * (both ? y[1 - j] / (y[0] + y[1]) : 1);
        force[j] = y[j] * (triplet.stiffness[j] * y[j] * y[j] + triplet.damping * w) * clock;
      } else {
        d[j] = -w * clock;
      }
    }
    d[velocity_at] = -force[0];
    d[velocity_at + 1] = force[0] - force[1];
    d[velocity_at + 2] = force[1];
    d[time_at] = clock;
    return d;
  }

  Real load(const State& y, std::size_t j) const {
    const Real depth = carries(j) ? y[j] * y[j] : -y[j];
    return triplet.stiffness[j] * depth + triplet.damping * rate(y, j);
  }
  /// What falls through zero when the contact leaves its mode.
  Real guard(const State& y, std::size_t j) const {
    if (mode[j] == Mode::open) return y[j];
    if (mode[j] == Mode::slack) return std::min(-load(y, j), -y[j]);
    return triplet.damping > 0 ? load(y, j) : y[j];
  }

  State after(Real h) const {
    return extrapolate([this](const State& y) { return derivative(y); }, state, h).x;
  }

  /// The step in (0, h] after which guard j is zero, given that it is negative after h.
  Real crossing(std::size_t j, Real h) const {
    Real low = 0, high = h, at_low = std::max<Real>(guard(state, j), 0), at_high = guard(after(h), j);
    for (int i = 0; i < 200 && high - low > located * high; ++i) {
      Real middle = (low * at_high - high * at_low) / (at_high - at_low);
      if (i % 3 == 2 || !(middle > low && middle < high)) middle = (low + high) / 2;
      const Real at_middle = guard(after(middle), j);
      (at_middle > 0 ? low : high) = middle;
      (at_middle > 0 ? at_low : at_high) = at_middle;
      if (at_middle == 0) return middle;
    }
    return high;
  }

  /// Change of a guard along the clock; its sign tells a dip within a step.
  Real slope(const State& y, std::size_t j) const {
    constexpr Real tiny = 1e-9L;
    const State d = derivative(y);
    State ahead = y;
    for (std::size_t i = 0; i < ahead.size(); ++i) ahead[i] += tiny * d[i];
    return guard(ahead, j) - guard(y, j);
  }
  /// Where guard j is least within a step at whose ends it falls and rises.
  Real lowest(std::size_t j, Real h) const {
    Real low = 0, high = h;
    for (int i = 0; i < 40; ++i) {
      const Real middle = (low + high) / 2;
      (slope(after(middle), j) < 0 ? low : high) = middle;
    }
    return low;
  }
  /// The first crossing within a step that ends at `next`, or the step itself and no contact (2).
  std::pair<Real, std::size_t> first_crossing(const State& next, Real h) const {
    std::pair<Real, std::size_t> first{h, 2};
    for (std::size_t j = 0; j < 2; ++j) {
      Real limit = h;
      if (guard(next, j) > 0 && slope(state, j) < 0 && slope(next, j) > 0) limit = lowest(j, h);
      if (guard(after(limit), j) > 0) continue;
      if (const Real at = crossing(j, limit); at < first.first || first.second == 2) first = {at, j};
    }
    return first;
  }

  void begin(std::size_t j) {
    const bool slack = mode[j] == Mode::slack;
    state[j] = slack ? sqrt(std::max<Real>(-state[j], 0)) : 0;
    mode[j] = Mode::carrying;
    ++outcome.periods[j];
  }
  void end(std::size_t j) {
    const bool indented = triplet.damping > 0;
    state[j] = indented ? -state[j] * state[j] : 0;
    mode[j] = indented ? Mode::slack : Mode::open;
    outcome.end = state[time_at];
  }
  void change(std::size_t j) {
    if (mode[j] == Mode::carrying) {
      end(j);
    } else if (mode[j] == Mode::slack && -load(state, j) > -state[j]) {
      state[j] = 0;
      mode[j] = Mode::open;
    } else {
      begin(j);
    }
    for (std::size_t i = 0; i < 2; ++i)
      if (carries(i) && triplet.damping == 0 && state[i] < negligible && rate(state, i) < 0) end(i);
  }

  /// To the next change of mode, with at least one contact carrying.
  void contact() {
    for (Real h = first_step;;) {
      const auto field = [this](const State& y) { return derivative(y); };
      const auto next = extrapolate(field, state, h);
      const Real factor = pow(allowed / std::max<Real>(next.error, 1e-40L), 1.0L / 19);
      if (!(next.error <= 8 * allowed)) {  // NaN included
        h *= std::clamp<Real>(0.9L * factor, 0.1L, 0.7L);
        continue;
      }
      const auto [step, j] = first_crossing(next.x, h);
      state = j < 2 ? after(step) : next.x;
      if (j < 2) return change(j);
      h = std::min(longest_step, h * std::clamp<Real>(0.9L * factor, 0.3L, 2.0L));
    }
  }

  /// To the next meeting; false if there is none.
  bool flight() {
    Real wait = 0;
    std::size_t next = 2;
    for (std::size_t j = 0; j < 2; ++j) {
      const Real w = rate(state, j), meeting = std::max<Real>(state[j], 0) / w;
      if (w <= 0 || (next < 2 && meeting >= wait)) continue;
      wait = meeting;
      next = j;
    }
    if (next == 2) return false;
    for (std::size_t j = 0; j < 2; ++j) state[j] -= wait * rate(state, j);
    state[time_at] += wait;
    begin(next);
    return true;
  }

  /// Of the stiffer spring and of the damper; and below this time a light damper outweighs its spring.
  Real natural_time() const {
    const Real spring = pow(std::max(triplet.stiffness[0], triplet.stiffness[1]), -0.4L);
    if (triplet.damping == 0) return spring;
    return std::min({spring, pow(triplet.damping, -2 / 3.0L), triplet.damping});
  }

  /// Both contacts begin at once: series of velocities and indentations by repeated integration.
  void start_together() {
    std::array<Series, 3> v{};
    std::array<Series, 2> depth{}, force{};
    for (std::size_t i = 0; i < 3; ++i) v[i][0] = triplet.velocity[i];
    for (std::size_t pass = 0; pass < degree / 6 + 2; ++pass) {
      for (std::size_t j = 0; j < 2; ++j) {
        Series w{}, load{};
        for (std::size_t n = 0; n <= degree; ++n) w[n] = v[j][n] - v[j + 1][n];
        depth[j] = integral(0, w);
        for (std::size_t n = 0; n <= degree; ++n)
          load[n] = triplet.stiffness[j] * depth[j][n] + triplet.damping * w[n];
        force[j] = product(root(depth[j]), load);
      }
      Series middle{}, first{};
      for (std::size_t n = 0; n <= degree; ++n) {
        first[n] = -force[0][n];
        middle[n] = force[0][n] - force[1][n];
      }
      v = {integral(triplet.velocity[0], first), integral(triplet.velocity[1], middle),
           integral(triplet.velocity[2], force[1])};
    }
    state[time_at] = start_share * natural_time();
    const Real z = pow(state[time_at], 0.25L);
    for (std::size_t j = 0; j < 2; ++j) state[j] = sqrt(value(depth[j], z));
    for (std::size_t i = 0; i < 3; ++i) state[velocity_at + i] = value(v[i], z);
  }
};

}  // namespace

Outcome impact(const Triplet& triplet) {
  Simulation run{.triplet = triplet};
  std::copy(triplet.velocity.begin(), triplet.velocity.end(), run.state.begin() + velocity_at);
  for (std::size_t j = 0; j < 2; ++j)
    if (Simulation::rate(run.state, j) > 0 || (j == 1 && Simulation::rate(run.state, j) == 0)) run.begin(j);
  if (run.carries(0) && run.carries(1)) run.start_together();
  do
    while (run.carries(0) || run.carries(1)) run.contact();
  while (run.flight());
  std::copy_n(run.state.begin() + velocity_at, 3, run.outcome.velocity.begin());
  return run.outcome;
}

}  // namespace mariotte::reference
