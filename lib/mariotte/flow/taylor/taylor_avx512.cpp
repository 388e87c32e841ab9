// The series in registers of eight, for processors with AVX-512.
#define MARIOTTE_INSTRUCTION_SET avx512
#define MARIOTTE_VECTOR_BYTES 64
#include "mariotte/flow/taylor/taylor_series.hpp"

namespace mariotte::flow::taylor {

std::unique_ptr<Expansion> make_avx512_expansion(std::size_t size) {
  return avx512::make(size);
}

}  // namespace mariotte::flow::taylor
