// The right-hand side that every rival gets: all balls of the row, forces cut off at zero, no events. They
// are told when the impact ends.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "measuring/rivals.hpp"
#include "row.hpp"

namespace mariotte::scaling_study {

/// State: n−1 gaps, then n velocities.
struct WholeRow {
  static constexpr bool damped = false;
  std::size_t balls;

  std::size_t contacts() const { return balls - 1; }
  std::size_t size() const { return contacts() + balls; }
  double end() const { return measuring::overtime * end_time(balls); }
  void start(double* x) const {
    std::fill(x, x + size(), 0.0);
    x[contacts()] = 1;
  }
  std::vector<double> velocity(const double* x) const { return {x + contacts(), x + size()}; }

  void accelerations(const double* gap, const double* /*velocity*/, double* acceleration) const {
    double left = 0;
    for (std::size_t j = 0; j < contacts(); ++j) {
      const double depth = std::max(0.0, -gap[j]), force = depth * std::sqrt(depth);
      acceleration[j] = left - force;
      left = force;
    }
    acceleration[contacts()] = left;
  }
  void operator()(const double* x, double* dx) const {
    const double* velocity = x + contacts();
    for (std::size_t j = 0; j < contacts(); ++j) dx[j] = velocity[j + 1] - velocity[j];
    accelerations(x, velocity, dx + contacts());
  }
};

}  // namespace mariotte::scaling_study
