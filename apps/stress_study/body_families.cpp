#include "family.hpp"

namespace mariotte::stress_study {

std::vector<Family> body_families() {
  return {};
}

}  // namespace mariotte::stress_study
