#include "mariotte/flow/triplet/triplet.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mariotte/flow/pair/pair_motion.hpp"

namespace mariotte::flow {
namespace {

/// Balls that rattle for longer are not of the common course.
constexpr int most_periods = 30;

void leave(Triplet& t) {
  t.stage = TripletStage::leaves;
}

/// The gap of contact b while contact c alone is closed.
ConcaveGap gap_of(const Triplet& t, int b, int c) {
  const double share = t.cross[b] / t.own[c];
  return {-t.indentation[b], -t.rate[b] - share * t.rate[c], share};
}

/// Moves both on by `time`, after which the closed contact c is `now`.
void move(Triplet& t, int c, const ConcaveGap& gap, double time, const Indentation& now) {
  const int b = 1 - c;
  t.indentation[b] = -(gap.value + gap.rate * time + gap.coupling * (now.value - t.indentation[c]));
  t.rate[b] = -(gap.rate + gap.coupling * now.rate);
  t.indentation[c] = now.value;
  t.rate[c] = now.rate;
  t.time += time;
}

bool touches_at_rest(const Triplet& t, int j) {
  return !t.closed[j] && t.indentation[j] == 0 && t.rate[j] == 0;
}

void start_period(Triplet& t, int j) {
  t.flights.begin(t.time);
  t.closed[j] = true;
  t.indentation[j] = 0;
  if (!(t.rate[j] > t.noise_speed) && t.rate[j] != 0) leave(t);
  if (++t.periods[j] + t.periods[1 - j] > most_periods) leave(t);
}

}  // namespace

void close(Triplet& t, int j) {
  start_period(t, j);
  ++t.events;
  const bool presses = touches_at_rest(t, 1 - j);
  if (presses) start_period(t, 1 - j);
  if (t.stage == TripletStage::leaves) return;
  t.striker = j;
  t.stage = presses ? TripletStage::pressed : t.closed[1 - j] ? TripletStage::both : TripletStage::alone;
}

void begin(Triplet& t) {
  const auto strikes = [&](int j) { return t.indentation[j] == 0 && t.rate[j] > 0; };
  if (strikes(0) && strikes(1)) {
    start_period(t, 0);
    start_period(t, 1);
    t.events = 1;
    if (t.stage != TripletStage::leaves) t.stage = TripletStage::struck;
  } else if (strikes(0) || strikes(1)) {
    close(t, strikes(1));
  }
}

void begin_series(Triplet& t, double time, bool is_certain) {
  t.time += time;
  ++t.series_steps;
  t.stage = is_certain ? TripletStage::both : TripletStage::leaves;
}

void let_go(Triplet& t, int j) {
  if (j < 0 || !(t.rate[j] < 0)) return leave(t);
  const int other = 1 - j;
  const double depth = t.indentation[other], rate = t.rate[other];
  const bool parts = depth <= -rate * t.same_instant;
  const bool rests = std::abs(rate) <= t.noise_speed && t.weight[other] * std::sqrt(depth) <= t.noise_root;
  if (parts || rests) return leave(t);
  t.flights.end(t.time);
  t.closed[j] = false;
  t.indentation[j] = 0;
  ++t.events;
  t.stage = TripletStage::alone;
}

void end_pair(Triplet& t, double time, const Indentation& pushing, const Indentation& other) {
  const int c = t.closed[1], b = 1 - c;
  if (!(other.value <= 0)) {
    t.stage = TripletStage::meets;
    return;
  }
  ++t.steps;
  ++t.events;
  t.time += time;
  t.flights.end(t.time);
  t.closed[c] = false;
  for (const auto& [j, now] : {std::pair{c, pushing}, {b, other}})
    t.indentation[j] = now.value, t.rate[j] = now.rate;
  t.stage = TripletStage::flight;
  if (other.rate > 0 && -other.value <= t.same_instant * other.rate) leave(t);
}

void meet(Triplet* triplet) {
  auto& t = *triplet;
  const int c = t.closed[1], b = 1 - c;
  const HertzMotion motion({.stiffness = t.own[c], .damping = 0, .exponent = 1.5, .reduced_mass = 1},
                           {t.indentation[c], t.rate[c]});
  const auto gap = gap_of(t, b, c);
  const auto [time, now] = motion.meet(gap);
  ++t.steps;
  if (!(time > 0) || motion.duration() - time <= t.same_instant) return leave(t);
  move(t, c, gap, time, now);
  close(t, b);
}

void fly(Triplet* triplet) {
  auto& t = *triplet;
  if (t.rate[0] <= t.noise_speed && t.rate[1] <= t.noise_speed) {
    t.stage = TripletStage::over;
    return;
  }
  const auto meets = [&](int j) { return t.rate[j] > 0 ? -t.indentation[j] / t.rate[j] : infinity; };
  const double times[2] = {meets(0), meets(1)};
  const int j = times[1] < times[0];
  if (times[1 - j] - times[j] <= t.same_instant) return leave(t);
  ++t.steps;
  t.time += times[j];
  if (!touches_at_rest(t, 1 - j)) t.indentation[1 - j] += times[j] * t.rate[1 - j];
  close(t, j);
}

}  // namespace mariotte::flow
