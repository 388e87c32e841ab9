// The series in registers of four, for processors with AVX2 and FMA.
#define MARIOTTE_INSTRUCTION_SET avx2
#define MARIOTTE_VECTOR_BYTES 32
#include "mariotte/flow/taylor/taylor_series.hpp"

namespace mariotte::flow::taylor {

std::unique_ptr<Expansion> make_avx2_expansion(std::size_t size) {
  return avx2::make(size);
}

}  // namespace mariotte::flow::taylor
