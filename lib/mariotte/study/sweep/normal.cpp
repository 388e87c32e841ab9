#include "mariotte/study/sweep/normal.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>

namespace mariotte::study {
namespace {

/// In plain double: tables of long double are made when the program starts, which valgrind cannot do.
using Plain = boost::math::policies::policy<boost::math::policies::promote_double<false>>;
using Normal = boost::math::normal_distribution<double, Plain>;

}  // namespace

double normal_quantile(double probability) {
  constexpr double smallest = 0x1p-54;  // half the distance of drawn numbers
  return quantile(Normal(), std::clamp(probability, smallest, 1 - 2 * smallest));
}

}  // namespace mariotte::study
