#include "mariotte/impact/pair/pair_restitution.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mariotte/contact/branched_law.hpp"
#include "mariotte/core/bracket.hpp"
#include "mariotte/core/error.hpp"
#include "mariotte/impact/capture_bracket.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"

namespace mariotte::impact {
namespace {

using contact::Branch;
using contact::BranchedLaw;
using contact::Memory;

void expect_speed(double speed) {
  if (!(speed > 0 && speed < infinity)) throw InvalidParameter("the speed must be positive and finite");
}

/// The pair as a ball and a wall.
const BriefImpact& run(ChainSolver& solver, const Pair& pair, double speed) {
  const auto& impact = solver.solve(
      {.mass = {pair.reduced_mass, infinity}, .law = {pair.law}, .gap = {0}, .velocity = {speed, 0}},
      {.accuracy = 1e-13});
  if (impact.ending != hybrid::Ending::separated && impact.ending != hybrid::Ending::bound)
    throw Error(std::string("a run ended with ") + hybrid::name(impact.ending) + ": " + impact.message);
  return impact;
}

/// k δ + c δ̇ with the damping ratio ζ, cut off at f = 0.
double linear_restitution(double zeta) {
  const double split = std::sqrt(std::abs(1 - zeta)) * std::sqrt(1 + zeta);
  if (split < 1e-7) return std::exp(-2.0);
  const double angle = zeta < 1 ? std::atan2(split, zeta) : std::asinh(split);  // arccos ζ, or arcosh ζ
  return std::exp(-2 * zeta / split * angle);
}

/// t + e⁻ᵗ − 1 for t > −1, without cancellation.
double decay_excess(double t) {
  if (std::abs(t) >= 1) return t + std::expm1(-t);
  double term = t * t / 2, sum = 0;
  for (int k = 3; std::abs(term) > 0.1 * epsilon * sum; ++k) {
    sum += term;
    term *= -t / k;
  }
  return sum;
}

/// The root e of x (1 + e) = ln[(1 + x)/(1 − e x)] at x = a v, which falls from 1 with x. With t = −ln(1 − e
/// x) it is t + e⁻ᵗ − 1 = x − ln(1 + x), and neither side loses digits where e x tends to 1, or to 0.
double hunt_crossley_restitution(double x) {
  if (x < epsilon) return 1;
  const double p = std::log1p(x), taken = p < 1 ? decay_excess(-p) : x - p;
  const auto left = [&](double t) { return std::pair(taken - decay_excess(t), std::expm1(-t)); };
  const double most = taken + std::sqrt(2 * taken);
  return -std::expm1(-locate_fall(left, 0, most, 4 * epsilon * most)) / x;
}

/// The deepest point follows from the energy on the way in, the speed from what is stored there.
double energy_restitution(const BranchedLaw& law, double energy) {
  const double limit = law.yield_indentation({});
  const auto at_peak = [&](double d) -> Memory {
    return d > limit ? Memory{.branch = Branch::unloading, .peak = d} : Memory{};
  };
  const double from = law.closing_indentation({}), start = law.stored_energy(Memory{}, from);
  const auto excess = [&](double d) {
    return law.stored_energy(at_peak(d), d) + law.plastic_loss(d) - start - energy;
  };
  double low = from, high = law.natural_indentation(energy);
  while (excess(high) < 0) high = low + 2 * (high - low);
  const double peak = locate_sign_change(excess, low, excess(low), high, excess(high), epsilon * high);
  const auto past = at_peak(peak);
  const double back = law.stored_energy(past, peak) - law.stored_energy(past, law.opening_indentation(past));
  return std::sqrt(std::max(0.0, back / energy));
}

double parameter(const contact::Law& law, std::string_view key) {
  for (const auto& one : parameters(law))
    if (one.key == key) return one.value;
  throw Error("the law has no " + std::string(key));
}

}  // namespace

double restitution(const Pair& pair, double speed) {
  expect_speed(speed);
  ChainSolver solver;
  const auto& impact = run(solver, pair, speed);
  return impact.ending == hybrid::Ending::bound ? 0 : -impact.velocity[0] / speed;
}

std::optional<double> closed_restitution(const Pair& pair, double speed) {
  expect_speed(speed);
  const auto& law = pair.law;
  if (const auto* branches = contact::branched(law)) {
    if (branches->is_damped()) return std::nullopt;
    return energy_restitution(*branches, 0.5 * pair.reduced_mass * speed * speed);
  }
  if (!contact::dissipates(law)) return 1;
  const auto ratio = [&] {
    return parameter(law, "damping") / (2 * std::sqrt(pair.reduced_mass * parameter(law, "stiffness")));
  };
  if (const auto* power = power_law(law)) {
    if (power->exponent == 1) return linear_restitution(ratio());
    return std::nullopt;
  }
  if (name(law) == "tsuji") return linear_restitution(2 * ratio() / std::sqrt(5.0));
  if (name(law) == "hunt-crossley") return hunt_crossley_restitution(parameter(law, "damping") * speed);
  return std::nullopt;
}

std::optional<CaptureVelocity> capture_velocity(const Pair& pair, double guess, double tolerance) {
  ChainSolver solver;
  const auto rebound = [&](double speed) {
    const auto& impact = run(solver, pair, speed);
    const double comes_off = impact.ending == hybrid::Ending::bound ? 0 : impact.velocity[0];
    return ReboundSpeed{comes_off, speed * impact.estimated_accuracy.value_or(0)};
  };
  return bracket_capture(rebound, guess, tolerance);
}

}  // namespace mariotte::impact
