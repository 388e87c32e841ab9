#include "mariotte/flow/flight.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mariotte/core/bracket.hpp"
#include "mariotte/core/state_vectors.hpp"
#include "mariotte/flow/flows.hpp"

namespace mariotte::flow {
namespace {

/// Time between which and `last` a height can fall through zero: its envelope is at or below zero there. From
/// `up` to `down` it flies too high: however often it turns meanwhile, nothing has to be looked at.
struct Window {
  double first = 0, last = infinity;
  double up = infinity, down = infinity;
};

/// Earlier and later zero of c + v t − g t²/2; both infinite if there is none.
std::pair<double, double> parabola_zeros(double c, double v, double g) {
  if (g == 0) return v == 0 ? std::pair{infinity, infinity} : std::pair{-c / v, -c / v};
  const double discriminant = v * v + 2 * g * c;
  if (discriminant < 0) return {infinity, infinity};
  const double sum = v + std::copysign(std::sqrt(discriminant), v);
  const double one = sum == 0 ? 0 : -2 * c / sum, other = sum / g;
  return std::minmax(one, other);
}

/// First t ≥ 0 with c + v t − g t²/2 ≤ 0.
double first_below(double c, double v, double g) {
  if (c <= 0) return 0;
  const auto [early, late] = parabola_zeros(c, v, g);
  if (early > 0) return early;
  return late > 0 ? late : infinity;
}

Window search_window(const TipHeight& h) {
  const double centre = h.start - h.swing * std::cos(h.phase), reach = std::abs(h.swing);
  Window window{.first = first_below(centre - reach, h.rate, h.gravity)};
  window.last = first_below(centre + reach, h.rate, h.gravity);
  if (window.last == 0) window.last = parabola_zeros(centre + reach, h.rate, h.gravity).second;
  if (h.gravity <= 0) {  // it may escape: no touch once the lower envelope has risen for good
    const double risen = parabola_zeros(centre - reach, h.rate, h.gravity).second;
    if (std::isfinite(risen) && risen > 0 && (h.rate > 0 || h.gravity < 0))
      window.last = std::min(window.last, risen);
    if (h.rate == 0 && h.gravity == 0)
      window.last = h.turn > 0 ? window.first + 2 * std::numbers::pi / h.turn : 0;
    if (h.rate > 0 && h.gravity == 0 && !(risen > 0)) window.last = 0;
  }
  if (const auto [up, down] = parabola_zeros(centre - reach, h.rate, h.gravity); h.gravity > 0 && up > 0)
    window.up = up, window.down = down * (1 - 16 * epsilon);
  // A zero of an envelope is found to rounding only.
  window.up *= 1 + 16 * epsilon;
  window.first *= 1 - 16 * epsilon;
  window.last *= 1 + 16 * epsilon;
  return window;
}

/// First inflection after t, where cos(Ω t + φ) = −g/(B Ω²); infinite if there is none.
double next_inflection(const TipHeight& h, double t) {
  const double cosine = -h.gravity / (h.swing * h.turn * h.turn);
  if (h.swing == 0 || h.turn == 0 || !(std::abs(cosine) < 1)) return infinity;
  const double angle = std::acos(cosine), now = h.turn * t + h.phase, full = 2 * std::numbers::pi;
  double next = infinity;
  for (const double side : {angle, -angle}) {
    const double turns = std::floor((now - side) / full) + 1;
    double then = (side + turns * full - h.phase) / h.turn;
    if (!(then > t)) then += full / h.turn;
    next = std::min(next, then);
  }
  return next;
}

/// The zero of a monotone piece, if it falls through zero there.
double fall_in(const TipHeight& h, double low, double high) {
  const double before = h.at(low), after = h.at(high);
  if (!(before > 0 && after <= 0)) return infinity;
  return locate_sign_change([&](double t) { return h.at(t); }, low, before, high, after, 2 * epsilon * high);
}

}  // namespace

double TipHeight::at(double t) const {
  // cos(x + φ) − cos φ without cancellation
  const double half = 0.5 * turn * t;
  return start + t * (rate - 0.5 * gravity * t) - 2 * swing * std::sin(half) * std::sin(half + phase);
}
double TipHeight::slope(double t) const {
  return rate - gravity * t - swing * turn * std::sin(turn * t + phase);
}

double first_touch(const TipHeight& h) {
  const auto window = search_window(h);
  for (double low = window.first; low < window.last;) {
    const double high = std::min(window.last, next_inflection(h, low));
    const double rising = h.slope(low), risen = h.slope(high);
    double turn = high;
    if ((rising > 0) != (risen > 0))
      turn =
          locate_sign_change([&](double t) { return h.slope(t); }, low, rising, high, risen, epsilon * high);
    if (const double touch = fall_in(h, low, turn); touch < infinity) return touch;
    if (const double touch = fall_in(h, turn, high); touch < infinity) return touch;
    low = high >= window.up && high < window.down ? window.down : high;
  }
  return infinity;
}

Quaternion flown(const Quaternion& attitude, const Vector3& momentum, const SymmetricBody& body, double t) {
  const Vector3 axis = rotate(attitude, {1, 0, 0});
  const double twist = 1 / body.axial - 1 / body.transverse, size = norm(momentum);
  if (size == 0) return attitude;
  const auto spun = rotation(axis, twist * dot(momentum, axis) * t) * attitude;
  return normalized(rotation((1 / size) * momentum, size / body.transverse * t) * spun);
}

namespace {

class FlightStep final : public Step {
 public:
  FlightStep(const FreePhase& phase, ConstState x)
      : phase_(phase),
        attitude_(quaternion_at(x, phase.place.attitude)),
        velocity_(vector_at(x, phase.place.velocity)),
        momentum_(vector_at(x, phase.place.momentum)) {
    before = x;
  }

  void at(double t, State x) const override {
    std::copy(before.begin(), before.end(), x.begin());
    const auto& place = phase_.place;
    for (Index i = 0; i < 2; ++i)
      if (place.gap[i] >= 0) x[place.gap[i]] = height(i).at(t);
    x[place.position] += t * velocity_.e2;
    x[place.position + 1] += t * velocity_.e3;
    x[place.velocity] -= t * phase_.body.gravity;
    put(x, place.attitude, flown(attitude_, momentum_, phase_.body, t));
  }

  /// The axis turns about the momentum: a₁(t) = const + A cos(Ω t + φ).
  TipHeight height(Index tip) const {
    TipHeight h{.start = before[phase_.place.gap[tip]], .rate = velocity_.e1, .gravity = phase_.body.gravity};
    const double size = norm(momentum_), arm = phase_.body.arm[tip];
    if (size == 0 || arm == 0) return h;
    const Vector3 pole = (1 / size) * momentum_, axis = rotate(attitude_, {1, 0, 0});
    const double cosine = (axis - dot(axis, pole) * pole).e1, sine = -cross(pole, axis).e1;
    h.swing = arm * std::hypot(cosine, sine);
    h.phase = std::atan2(sine, cosine);
    h.turn = size / phase_.body.transverse;
    if (h.swing < 0) {
      h.swing = -h.swing;
      h.phase += std::numbers::pi;
    }
    return h;
  }

 private:
  const FreePhase& phase_;
  Quaternion attitude_;
  Vector3 velocity_, momentum_;
};

class Flight final : public Flow {
 public:
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override {
    const FreePhase& phase = *problem.free_body();
    start_.assign(x.begin(), x.end());
    FlightStep step(phase, start_);
    double touch = infinity;
    Index tip = -1;
    for (Index i = 0; i < 2; ++i) {
      if (phase.place.gap[i] < 0) continue;
      const double time = first_touch(step.height(i));
      if (time >= touch) continue;
      touch = time;
      tip = i;
    }
    if (tip < 0) return {.outcome = Outcome::never};
    const bool touches = touch <= request.limit;
    step.end = touches ? touch : request.limit;
    step.at(step.end, x);
    if (touches) {
      x[phase.place.gap[tip]] = 0;
      fired.push_back(phase.guard[tip]);
    }
    step.after = x;
    if (request.observer) request.observer->observe(step);
    return {.outcome = touches ? Outcome::guard : Outcome::limit, .duration = step.end, .steps = 1};
  }

 private:
  std::vector<double> start_;
};

}  // namespace

std::unique_ptr<Flow> make_flight_flow() {
  return std::make_unique<Flight>();
}

}  // namespace mariotte::flow
