#include "mariotte/study/sweep/sobol.hpp"

#include <boost/random/sobol.hpp>

#include "mariotte/study/sweep/random.hpp"

namespace mariotte::study {
namespace {

/// The engine begins after the point of zeros.
std::uint64_t digits(std::size_t coordinate, std::uint64_t point) {
  if (point == 0) return 0;
  boost::random::sobol engine(coordinate + 1);
  engine.seed(point - 1);
  engine.discard(coordinate);
  return engine();
}

}  // namespace

double sobol(std::uint64_t seed, std::size_t coordinate, std::uint64_t point) {
  return static_cast<double>((digits(coordinate, point) ^ mix(mix(seed) ^ coordinate)) >> 11) * 0x1p-53;
}

}  // namespace mariotte::study
