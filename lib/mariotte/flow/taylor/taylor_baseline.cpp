// The series for any processor.
#define MARIOTTE_INSTRUCTION_SET baseline
#define MARIOTTE_VECTOR_BYTES 16
#include "mariotte/flow/taylor/taylor_series.hpp"

namespace mariotte::flow::taylor {

std::unique_ptr<Expansion> make_baseline_expansion(std::size_t size) {
  return baseline::make(size);
}

}  // namespace mariotte::flow::taylor
