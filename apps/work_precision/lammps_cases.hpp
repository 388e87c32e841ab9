// Two equal balls that meet, as mariotte and as LAMMPS state them.
#pragma once
#include <string>
#include <vector>

#include "mariotte/model/bodies/bodies.hpp"

namespace mariotte::work_precision {

struct LammpsCase {
  std::string name;
  model::Bodies bodies;
  std::string pair_coeff;  ///< of pair_style granular
};

/// Laws that both have, with the numbers of LAMMPS' manual turned into those of the law.
std::vector<LammpsCase> lammps_cases();

}  // namespace mariotte::work_precision
