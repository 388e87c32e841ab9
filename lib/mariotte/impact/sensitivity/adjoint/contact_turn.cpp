#include "mariotte/impact/sensitivity/adjoint/contact_turn.hpp"

namespace mariotte::impact {

UntilEnd::UntilEnd() {
  for (int j = 0; j < stages; ++j)
    for (int i = 0; i < stages; ++i) weight[j][i] = gauss.weight[j] - gauss.integral[i][j];
}

}  // namespace mariotte::impact
