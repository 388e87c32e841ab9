// The series for any processor.
#define MARIOTTE_INSTRUCTION_SET baseline
#define MARIOTTE_VECTOR_BYTES 16
#include "mariotte/flow/taylor/tip_kinds.hpp"

namespace mariotte::flow {

std::unique_ptr<TipExpansions> make_baseline_tip_expansions() {
  return std::unique_ptr<TipExpansions>(new tips::baseline::Expansions);
}

}  // namespace mariotte::flow
