// Triplets in registers of four, for processors with AVX2 and FMA.
#define MARIOTTE_INSTRUCTION_SET avx2
#define MARIOTTE_VECTOR_BYTES 32
#include "mariotte/flow/triplet/triplet_series.hpp"

namespace mariotte::flow {

std::unique_ptr<TripletLanes> make_avx2_triplet_lanes(Lanewise lanewise) {
  return taylor::avx2::make_triplet_lanes(lanewise);
}

}  // namespace mariotte::flow
