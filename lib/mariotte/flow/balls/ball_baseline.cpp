// The series for any processor.
#define MARIOTTE_INSTRUCTION_SET baseline
#define MARIOTTE_VECTOR_BYTES 16
#include "mariotte/flow/balls/ball_kinds.hpp"

namespace mariotte::flow {

std::unique_ptr<BallExpansions> make_baseline_ball_expansions() {
  return std::unique_ptr<BallExpansions>(new balls::baseline::Expansions);
}

}  // namespace mariotte::flow
