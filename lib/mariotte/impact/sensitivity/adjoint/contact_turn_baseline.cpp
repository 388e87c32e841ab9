// A sweep at one contact for any processor.
#define MARIOTTE_INSTRUCTION_SET baseline
#define MARIOTTE_VECTOR_BYTES 16
#include "mariotte/impact/sensitivity/adjoint/contact_turn_steps.hpp"

namespace mariotte::impact {

void turn_by_baseline(const ContactTurn& contact) {
  baseline::turn(contact);
}

}  // namespace mariotte::impact
