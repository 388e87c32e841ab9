#include "family.hpp"

namespace mariotte::stress_study {

std::vector<Family> network_families() {
  return {};
}

}  // namespace mariotte::stress_study
