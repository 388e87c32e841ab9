// The right-hand side that every rival gets of a chain: N balls of unit mass, written for speed. The number
// of balls and the law are known to the compiler, so that everything is inlined and nothing is allocated.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "rival.hpp"

namespace mariotte::work_precision {

/// Forces before they are cut off where they would pull; `depth` may be negative.
struct LinearForce {
  static constexpr bool damped = false;
  static constexpr double depth_power = -0.5;
  static double at(double stiffness, double /*damping*/, double depth, double /*rate*/) {
    return stiffness * depth;
  }
};
struct HertzForce {
  static constexpr bool damped = false;
  static constexpr double depth_power = -0.4;
  static double at(double stiffness, double /*damping*/, double depth, double /*rate*/) {
    return stiffness * depth * std::sqrt(std::max(0.0, depth));
  }
};
struct ViscoelasticForce {
  static constexpr bool damped = true;
  static constexpr double depth_power = -0.4;
  static double at(double stiffness, double damping, double depth, double rate) {
    return std::sqrt(std::max(0.0, depth)) * (stiffness * depth + damping * rate);
  }
};

/// State: N−1 gaps, then N velocities.
template <std::size_t N, class Force>
struct Field {
  static constexpr std::size_t balls = N;
  static constexpr std::size_t contacts = N - 1;
  static constexpr std::size_t size = contacts + N;
  static constexpr bool damped = Force::damped;
  static constexpr double overtime = measuring::overtime;
  using State = std::array<double, size>;

  std::array<double, contacts> stiffness{};
  double damping = 0;

  Field() = default;
  Field(const Case& one, const Setting&) {
    for (std::size_t j = 0; j < contacts; ++j) stiffness[j] = contact::stiffness(chain_of(one).law[j]);
    damping = contact::damping(chain_of(one).law[0]);
  }
  static void start(const Case& one, double* x) {
    std::copy(chain_of(one).gap.begin(), chain_of(one).gap.end(), x);
    std::copy(chain_of(one).velocity.begin(), chain_of(one).velocity.end(), x + contacts);
  }
  static void finish(const double* x, Answer& answer) {
    std::copy(x + contacts, x + size, answer.velocity.begin());
  }
  /// Size of a gap during an impact at unit speed of unit masses.
  double depth(std::size_t contact) const { return std::pow(stiffness[contact], Force::depth_power); }
  /// Of each component: what its absolute tolerance is relative to.
  State magnitudes() const {
    State magnitude;
    magnitude.fill(1);
    for (std::size_t j = 0; j < contacts; ++j) magnitude[j] = depth(j);
    return magnitude;
  }

  /// Force of contact j, not cut off.
  double smooth_force(std::size_t j, const double* gap, const double* velocity) const {
    return Force::at(stiffness[j], damping, -gap[j], velocity[j] - velocity[j + 1]);
  }
  /// Accelerations at these gaps and velocities; every force passes through `cut(j, smooth)`.
  template <class Cut>
  void accelerations(const double* gap, const double* velocity, double* acceleration, const Cut& cut) const {
    std::array<double, N + 1> force;  // 0, N−1 contacts, 0
    force[0] = force[N] = 0;
    for (std::size_t j = 0; j < contacts; ++j) force[j + 1] = cut(j, smooth_force(j, gap, velocity));
    for (std::size_t i = 0; i < N; ++i) acceleration[i] = force[i] - force[i + 1];
  }
  void accelerations(const double* gap, const double* velocity, double* acceleration) const {
    accelerations(gap, velocity, acceleration, pushing);
  }
  template <class Cut>
  void derivative(const double* x, double* dx, const Cut& cut) const {
    const double* velocity = x + contacts;
    for (std::size_t j = 0; j < contacts; ++j) dx[j] = velocity[j + 1] - velocity[j];
    accelerations(x, velocity, dx + contacts, cut);
  }
  void operator()(const double* x, double* dx) const { derivative(x, dx, pushing); }

  static double pushing(std::size_t, double force) { return std::max(0.0, force); }
};

/// `make.operator()<Field>()` for the field of a problem; empty if it is no chain.
template <class Make>
Solve with_chain_field(const Problem& problem, const Make& make) {
  if (problem.has_body()) return {};
  const auto& chain = chain_of(problem.cases.front());
  const bool linear = contact::name(chain.law[0]) == "linear";
  const bool hertz = contact::name(chain.law[0]) == "hertz";
  if (chain.mass.size() == 21 && hertz) return make.template operator()<Field<21, HertzForce>>();
  if (chain.mass.size() != 3) throw Error("no rival has been compiled for so many balls");
  if (linear) return make.template operator()<Field<3, LinearForce>>();
  if (hertz) return make.template operator()<Field<3, HertzForce>>();
  return make.template operator()<Field<3, ViscoelasticForce>>();
}

/// A rival of chains as a Solve.
template <template <class> class Rival>
Solve chain_rival(const Problem& problem, double setting) {
  return with_chain_field(problem, [&]<class F>() { return solve_by<Rival<F>>(Setting{setting}, F::balls); });
}

}  // namespace mariotte::work_precision
