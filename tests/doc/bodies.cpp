// Prints what the text of [Cheng 2002] claims of its figures 8 to 15 and what its model gives when its
// misprints are corrected, as doc/microbodies.md quotes it.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>

#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"

using namespace mariotte;

namespace {

constexpr double radius = 2.45e-6, density = 1350, degree = std::numbers::pi / 180;
constexpr contact::Surface surface{.stiffness = 1.74e9, .adhesion = 0.38};

enum class Shape { dumbbell, rod };

struct Strike {
  Shape shape = Shape::rod;
  double length_ratio = 10, beta = 45, speed = 5, friction = 0.15;  // degrees, m/s
};

model::Microbody body_of(const Strike& strike) {
  const auto make = strike.shape == Shape::rod ? model::rod : model::dumbbell;
  model::Microbody body;
  body.body = make(radius, strike.length_ratio, density);
  body.law.assign(body.body.tips.size(),
                  contact::brach_dunn(
                      surface, radius, contact::hertz_damping(1.5, surface, radius, density, strike.speed),
                      contact::adhesion_damping(0.5, surface, radius, density, strike.speed)));
  body.friction = {strike.friction};
  body.attitude = from_euler({0, strike.beta * degree, 0});
  body.velocity = {-strike.speed, 0, 0};
  return body;
}

impact::BriefMicrobodyImpact solve(const Strike& strike) {
  static impact::MicrobodySolver solver;
  return solver.solve(body_of(strike));
}
double tip_restitution(const Strike& strike) {
  return solve(strike).tip_velocity / strike.speed;
}
double centre_restitution(const Strike& strike) {
  return solve(strike).velocity.e1 / strike.speed;
}

/// Where a function changes sign, given that it does.
double zero(const std::function<double(double)>& f, double low, double high) {
  const bool positive = f(low) > 0;
  for (int i = 0; i < 45; ++i) {
    const double middle = 0.5 * (low + high);
    ((f(middle) > 0) == positive ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double angle_without_rebound(double friction) {
  return zero([&](double beta) { return centre_restitution({.beta = beta, .friction = friction}); }, 20, 80);
}
double length_without_rebound(double friction) {
  return zero(
      [&](double length) {
        return centre_restitution({.length_ratio = length, .speed = 2, .friction = friction});
      },
      1, 20);
}
/// Length ratio, in the steps of the figure, at which the mass centre rebounds best.
double best_length(double friction) {
  double best = 0, most = 0;
  for (double length = 0; length <= 50; length += 0.5) {
    const double e =
        centre_restitution({.length_ratio = length, .beta = 20, .speed = 2, .friction = friction});
    if (e > most) {
      most = e;
      best = length;
    }
  }
  return best;
}

/// Of how many cases a claim holds.
struct Count {
  int held = 0, all = 0;
  void add(bool holds) {
    held += holds;
    ++all;
  }
};

/// The steps from 0 to end in which f rises or, with sign −1, falls.
Count monotone(const std::function<double(double)>& f, double end, double step, double sign) {
  Count count;
  for (double x = step; x <= end; x += step) count.add(sign * (f(x) - f(x - step)) > 0);
  return count;
}

double final_slip(double beta) {
  const auto impact = impact::simulate(body_of({.beta = beta, .friction = 0.7}));
  return norm(impact.impacts.at(0).slip_out);
}

/// The tip slips all the time, one way first and the other way later.
bool slip_reverses(double beta) {
  const auto impact = impact::simulate(body_of({.beta = beta}));
  int slips = 0;
  for (const auto& event : impact.events) {
    if (!event.stick.empty()) return false;
    slips += !event.slip.empty();
  }
  return slips > 1;
}

/// First whole degree at which something holds.
int first_degree(const std::function<bool(double)>& holds) {
  for (int beta = 1; beta < 90; ++beta)
    if (holds(beta)) return beta;
  return 90;
}

bool other_end_strikes(double beta) {
  auto body = body_of({.beta = beta});
  body.impacts = 2;
  const auto impact = impact::simulate(body);
  return impact.impacts.size() == 2 && impact.impacts[1].tip == 1;
}

Count friction_helps_the_centre() {
  Count count;
  for (const double beta : {20, 45})
    for (double length = 0.5; length <= 50; length += 0.5) {
      const Strike with{.shape = Shape::dumbbell, .length_ratio = length, .beta = beta, .speed = 2};
      auto without = with;
      without.friction = 0;
      count.add(tip_restitution(with) < tip_restitution(without) &&
                centre_restitution(with) > centre_restitution(without));
    }
  return count;
}

/// A rod at 5 m/s with 200 impacts to come, of which it takes what the plane gives it.
impact::MicrobodyImpact struck_again(double length_ratio, double beta) {
  auto body = body_of({.length_ratio = length_ratio, .beta = beta});
  body.impacts = 200;
  return impact::simulate(body);
}

Count repeated_impacts_capture(Index& most) {
  Count count;
  for (const double length : {5, 10, 20})
    for (double beta = 10; beta < 90; beta += 10) {
      const auto impact = struck_again(length, beta);
      count.add(impact.ending == hybrid::Ending::captured);
      most = std::max(most, static_cast<Index>(impact.impacts.size()));
    }
  return count;
}

/// Largest speed of the contact point at the events between which the tip sticks, v_t - omega r otherwise
/// [m/s].
double slip_while_sticking(double beta) {
  const auto impact = impact::simulate(body_of({.beta = beta, .friction = 0.7}), {}, {.trace = true});
  double most = 0;
  for (std::size_t k = 0; k + 1 < impact.events.size(); ++k) {
    if (impact.events[k].stick.empty()) continue;
    for (std::size_t row = 0; row < impact.trace.state.size(); ++row)
      if (impact.trace.state[row].time > impact.events[k].time &&
          impact.trace.state[row].time < impact.events[k + 1].time)
        most = std::max(most, norm(impact.trace.slip[row][0]));
  }
  return most;
}

void print(const char* claim, const char* found, const char* verdict) {
  std::printf("%-60s %-52s %s\n", claim, found, verdict);
}

template <class... Values>
void print(const char* claim, const char* verdict, const char* format, Values... values) {
  char text[100];
  std::snprintf(text, sizeof text, format, values...);
  print(claim, text, verdict);
}

const char* verdict(bool holds) {
  return holds ? "true" : "false";
}
const char* verdict(const Count& count) {
  return count.held == count.all ? "true" : count.held == 0 ? "false" : "partly";
}

void print(const char* claim, const char* where, const Count& count) {
  print(claim, verdict(count), "in %d of %d %s", count.held, count.all, where);
}

void print_lengths() {
  print("fig. 8: friction 0.15 lowers e_n and raises e_nm", "cases: ratio 0.5 to 50, 20 and 45 deg",
        friction_helps_the_centre());
  const auto dumbbell = [](double length, double beta) {
    return tip_restitution({.shape = Shape::dumbbell, .length_ratio = length, .beta = beta, .speed = 2});
  };
  print("fig. 8: e_n hardly changes beyond a length ratio of 10", "partly",
        "%.3f to %.3f at 20 deg, %.3f to %.3f at 45 deg", dumbbell(10, 20), dumbbell(50, 20),
        dumbbell(10, 45), dumbbell(50, 45));
  print("concl. 1: e_n of a dumbbell is below that of the sphere", verdict(dumbbell(1, 45) < dumbbell(0, 45)),
        "%.4f at ratio 1, sphere %.4f", dumbbell(1, 45), dumbbell(0, 45));
  print("fig. 9: e_n of a rod grows with its length", "steps of 0.5 up to 50, 45 deg",
        monotone([](double x) { return tip_restitution({.length_ratio = x, .speed = 2}); }, 50, 0.5, 1));
  print("fig. 9: 45 deg, e_nm < 0 beyond a length ratio of 5", "partly",
        "%.3f without friction, %.2f with 0.15", length_without_rebound(0), length_without_rebound(0.15));
  print("fig. 9: 20 deg, e_nm is largest at a length ratio of 2", "partly",
        "%.1f without friction, %.1f with 0.15", best_length(0), best_length(0.15));
}

void print_tilts() {
  const auto restitution = [](double beta) { return tip_restitution({.beta = beta}); };
  print("fig. 10: e_n of a rod falls as it is tilted", "partly", "%.4f at 0, %.4f at 28, %.4f at 90 deg",
        restitution(0), restitution(28), restitution(90));
  print("fig. 10: e_nm < 0 beyond 42 deg", "partly", "%.2f, %.2f, %.2f deg with friction 0, 0.15, 0.7",
        angle_without_rebound(0), angle_without_rebound(0.15), angle_without_rebound(0.7));
  const auto duration = [](double beta) { return 1e9 * solve({.beta = beta}).time; };
  print("fig. 11-14: the contact is shorter at larger tilt", verdict(monotone(duration, 90, 1, -1)),
        "%.2f ns at 0 deg, %.2f ns at 90 deg", duration(0), duration(90));
  print("fig. 12: with friction 0.7 the tip does not slip at the end", "partly", "below 1 mm/s up to %d deg",
        first_degree([](double beta) { return final_slip(beta) > 1e-3; }) - 1);
  print("fig. 14: with friction 0.15 the slip reverses", "partly", "without sticking from %d deg on",
        first_degree(slip_reverses));
  Count strikes;
  for (int beta = 43; beta < 90; ++beta) strikes.add(other_end_strikes(beta));
  print("fig. 12, 14: the other end strikes later", "whole degrees from 43 to 89, no gravity", strikes);
}

void print_limits() {
  const Strike slim{.length_ratio = 1e6, .speed = 2, .friction = 0};
  const double damping = contact::hertz_damping(1.5, surface, radius, density, slim.speed) * slim.speed;
  print("concl.: e_n tends to 1 as the length ratio grows", verdict(tip_restitution(slim) > 0.999),
        "%.4f at ratio 1e6, 1 - 2/3 C_H v = %.4f", tip_restitution(slim), 1 - 2 * damping / 3);
  Index most = 0;
  const auto captured = repeated_impacts_capture(most);
  print("concl.: repeated impacts capture slim bodies", verdict(captured),
        "%d of %d rods, after %d impacts they fly off", captured.held, captured.all, static_cast<int>(most));
  double slip = 0;
  for (double beta = 5; beta <= 50; beta += 5) slip = std::max(slip, slip_while_sticking(beta));
  print("v_t = omega r while the tip sticks", verdict(slip < 1e-9), "%s",
        "within 1e-9 m/s, 5 to 50 deg, friction 0.7");
}

}  // namespace

int main() {
  print("claim", "computed", "verdict");
  print_lengths();
  print_tilts();
  print_limits();
}
