// The series in registers of four, for processors with AVX2 and FMA.
#define MARIOTTE_INSTRUCTION_SET avx2
#define MARIOTTE_VECTOR_BYTES 32
#include "mariotte/flow/balls/ball_kinds.hpp"

namespace mariotte::flow {

std::unique_ptr<BallExpansions> make_avx2_ball_expansions() {
  return std::unique_ptr<BallExpansions>(new balls::avx2::Expansions);
}

}  // namespace mariotte::flow
