// Slopes as series in registers of four, for processors with AVX2 and FMA.
#define MARIOTTE_INSTRUCTION_SET avx2
#define MARIOTTE_VECTOR_BYTES 32
#include "mariotte/impact/sensitivity/push_expansion_series.hpp"

namespace mariotte::impact {

std::unique_ptr<PushExpansion> make_avx2_push_expansion() {
  return std::make_unique<avx2::Expansion>();
}

}  // namespace mariotte::impact
