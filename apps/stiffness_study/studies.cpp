#include "study.hpp"

namespace mariotte::stiffness_study {

const std::vector<Study>& studies() {
  static const std::vector<Study> all = {
      {"stiffness", "Absolute stiffness and mass", true, stiffness_study},
      {"ratio", "Stiffness ratio", true, ratio_study},
      {"damping", "Damping", true, damping_study},
      {"scaling", "The group Π of damped contacts", true, scaling_study},
      {"conclusions", "The conclusions of the paper, on random chains", true, conclusions_study},
      {"crossover", "Where one flow becomes cheaper than another", false, crossover_study},
      {"network", "Dense and sparse matrices of contact networks", false, network_study},
      {"packing", "A wave through a packing of disks", false, packing_study}};
  return all;
}

}  // namespace mariotte::stiffness_study
