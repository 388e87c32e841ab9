// The laws whose curves are drawn, family by family, for pairs of reduced mass 1.
#pragma once
#include <string>
#include <vector>

#include "mariotte/contact/law.hpp"

namespace mariotte::paper_figures {

struct ShownLaw {
  std::string name;
  std::string at;  ///< what its force is shown at, for the legend
  contact::Law law;
  double speed;  ///< at which its force is shown
};

/// What axes are in units of.
struct LawUnits {
  double length, force, speed;
  std::string length_label, force_label, speed_label;
};

struct LawFamily {
  std::string name, what, title;
  std::vector<ShownLaw> laws;
  LawUnits unit;
  double slowest, fastest;  ///< speeds at which restitution is shown; 0 if all have e = 1
};

std::vector<LawFamily> law_families();

}  // namespace mariotte::paper_figures
