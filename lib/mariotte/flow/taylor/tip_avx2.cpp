// The series in registers of four, for processors with AVX2 and FMA.
#define MARIOTTE_INSTRUCTION_SET avx2
#define MARIOTTE_VECTOR_BYTES 32
#include "mariotte/flow/taylor/tip_kinds.hpp"

namespace mariotte::flow {

std::unique_ptr<TipExpansions> make_avx2_tip_expansions() {
  return std::unique_ptr<TipExpansions>(new tips::avx2::Expansions);
}

}  // namespace mariotte::flow
