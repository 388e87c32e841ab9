#include "mariotte/study/sweep/normal.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>

namespace mariotte::study {

double normal_quantile(double probability) {
  constexpr double smallest = 0x1p-54;  // half the distance of drawn numbers
  return quantile(boost::math::normal(), std::clamp(probability, smallest, 1 - 2 * smallest));
}

}  // namespace mariotte::study
