// What solvers tell of one impact that are asked for nothing that costs extra.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/hybrid/ending.hpp"

namespace mariotte::impact {

/// What a sweep asks of one impact, in the units of its model.
struct BriefImpact {
  hybrid::Ending ending = hybrid::Ending::separated;
  std::string message;           ///< why, for endings other than separated; else empty
  double time = 0;               ///< of the ending [s]
  std::vector<double> velocity;  ///< of each ball or degree of freedom [m/s]
  std::vector<double> impulse;   ///< of each contact [N s]
  std::vector<Index> periods;    ///< how often each contact carried force
  Index events = 0;              ///< instants at which contacts closed or opened
  Index steps = 0;
  Index rhs = 0;  ///< evaluations of the right-hand side, or of its series
  /// Difference to a looser run, relative to the largest incident speed; where contacts close again and again
  std::optional<double> estimated_accuracy;
  Index widest = 0;  ///< contacts of the largest island of a chain; all of them if the model was one system
};

}  // namespace mariotte::impact
