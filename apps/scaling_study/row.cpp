#include "row.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::scaling_study {

model::Chain row(std::size_t balls) {
  model::Chain chain{.mass = std::vector<double>(balls, 1.0),
                     .law = std::vector<contact::Law>(balls - 1, contact::Hertz{1}),
                     .gap = std::vector<double>(balls - 1, 0.0),
                     .velocity = std::vector<double>(balls, 0.0)};
  chain.velocity[0] = 1;
  return chain;
}

// Computed in extended precision, for 100 and 1000 balls alike.

double end_time(std::size_t balls) {
  return 119.228764299681853 + (static_cast<double>(balls) - 100) * 1.189755576980284;
}

double error_of(const std::vector<double>& v) {
  const std::size_t n = v.size();
  return std::max({std::abs(v[0] + 0.0710850170860943), std::abs(v[1] + 0.0302737893644727),
                   std::abs(v[n - 2] - 0.148600463236243), std::abs(v[n - 1] - 0.985678857090035)});
}

}  // namespace mariotte::scaling_study
