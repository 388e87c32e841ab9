#include "method.hpp"

namespace mariotte::scaling_study {

std::vector<Rival> rivals() {
  return {{"CVODE Adams", measure_cvode}, {"odeint rkf78", measure_odeint}, {"Verlet", measure_verlet}};
}

}  // namespace mariotte::scaling_study
