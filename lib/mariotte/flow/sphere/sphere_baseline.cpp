// Spheres in registers of two, for any processor.
#define MARIOTTE_INSTRUCTION_SET baseline
#define MARIOTTE_VECTOR_BYTES 16
#include "mariotte/flow/sphere/sphere_series.hpp"

namespace mariotte::flow {

std::unique_ptr<SphereLanes> make_baseline_sphere_lanes() {
  return std::make_unique<taylor::baseline::SphereSeries>();
}

}  // namespace mariotte::flow
