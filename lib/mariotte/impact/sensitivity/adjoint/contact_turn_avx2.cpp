// A sweep at one contact, for processors with AVX2 and FMA.
#define MARIOTTE_INSTRUCTION_SET avx2
#define MARIOTTE_VECTOR_BYTES 32
#include "mariotte/impact/sensitivity/adjoint/contact_turn_steps.hpp"

namespace mariotte::impact {

void turn_by_avx2(const ContactTurn& contact) {
  avx2::turn(contact);
}

}  // namespace mariotte::impact
