// Spheres in registers of four, for processors with AVX2 and FMA.
#define MARIOTTE_INSTRUCTION_SET avx2
#define MARIOTTE_VECTOR_BYTES 32
#include "mariotte/flow/sphere/sphere_series.hpp"

namespace mariotte::flow {

std::unique_ptr<SphereLanes> make_avx2_sphere_lanes() {
  return std::make_unique<taylor::avx2::SphereSeries>();
}

}  // namespace mariotte::flow
