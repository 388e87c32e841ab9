// Slopes as series for any processor.
#define MARIOTTE_INSTRUCTION_SET baseline
#define MARIOTTE_VECTOR_BYTES 16
#include "mariotte/impact/sensitivity/push_expansion_series.hpp"

namespace mariotte::impact {

std::unique_ptr<PushExpansion> make_baseline_push_expansion() {
  return std::make_unique<baseline::Expansion>();
}

}  // namespace mariotte::impact
