// Velocity Verlet with a thousand steps per unit of time.
#include "measuring/timing.hpp"
#include "method.hpp"
#include "whole_row.hpp"

namespace mariotte::scaling_study {

Measurement measure_verlet(std::size_t balls) {
  const WholeRow row{balls};
  std::vector<double> x(row.size());
  row.start(x.data());
  const auto steps = static_cast<Index>(std::ceil(1000 * row.end()));
  const double start = measuring::cpu_seconds();
  measuring::verlet(row, row.end(), steps, x.data(), x.data() + row.contacts(), std::vector<double>(balls));
  return {.seconds = measuring::cpu_seconds() - start,
          .error = error_of(row.velocity(x.data())),
          .steps = steps,
          .widest = static_cast<Index>(row.contacts())};
}

}  // namespace mariotte::scaling_study
