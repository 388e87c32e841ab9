// Triplets in registers of two, for any processor.
#define MARIOTTE_INSTRUCTION_SET baseline
#define MARIOTTE_VECTOR_BYTES 16
#include "mariotte/flow/triplet/triplet_series.hpp"

namespace mariotte::flow {

std::unique_ptr<TripletLanes> make_baseline_triplet_lanes(Lanewise lanewise) {
  return taylor::baseline::make_triplet_lanes(lanewise);
}

}  // namespace mariotte::flow
