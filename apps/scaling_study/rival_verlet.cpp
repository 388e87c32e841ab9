// Velocity Verlet with a fixed step: kick, drift, kick.
#include "method.hpp"
#include "whole_row.hpp"
#include "work_precision/timing.hpp"

namespace mariotte::scaling_study {

Measurement measure_verlet(std::size_t balls) {
  const WholeRow row{balls};
  std::vector<double> x(row.size()), acceleration(balls);
  row.start(x.data());
  double *gap = x.data(), *velocity = gap + row.contacts();
  const auto steps = static_cast<Index>(std::ceil(1000 * row.end()));
  const double h = row.end() / static_cast<double>(steps), start = work_precision::cpu_seconds();
  row.accelerations(gap, acceleration.data());
  for (Index step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < balls; ++i) velocity[i] += 0.5 * h * acceleration[i];
    for (std::size_t j = 0; j < row.contacts(); ++j) gap[j] += h * (velocity[j + 1] - velocity[j]);
    row.accelerations(gap, acceleration.data());
    for (std::size_t i = 0; i < balls; ++i) velocity[i] += 0.5 * h * acceleration[i];
  }
  return {.seconds = work_precision::cpu_seconds() - start,
          .error = error_of(row.velocity(x.data())),
          .steps = steps,
          .widest = static_cast<Index>(row.contacts())};
}

}  // namespace mariotte::scaling_study
