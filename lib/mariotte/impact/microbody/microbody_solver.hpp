// Many microbodies with the same memory: where they end up, and nothing that costs extra.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/impact/course.hpp"
#include "mariotte/model/microbody/microbody.hpp"

namespace mariotte::impact {

/// What a sweep asks of one impact, in the body's units.
struct BriefMicrobodyImpact {
  hybrid::Ending ending = hybrid::Ending::separated;
  std::string message;      ///< why, for endings other than separated and captured; else empty
  double time = 0;          ///< of the ending [s]
  Quaternion attitude;      ///< then
  Vector3 velocity, spin;   ///< of the mass centre [m/s]; space axes [rad/s]
  double tip_velocity = 0;  ///< normal velocity of the centre of the first tip [m/s]
  Index impacts = 0;        ///< contacts that have ended
  Index events = 0;         ///< instants at which something changed
  Index steps = 0;
  Index rhs = 0;  ///< evaluations of the right-hand side, or of its series
  /// Difference to a looser run, relative to the largest incident speed; where a run took many steps
  std::optional<double> estimated_accuracy;
};

/// Solves one body after the other with the same flows. Not to be shared between threads; each has its own.
class MicrobodySolver {
 public:
  explicit MicrobodySolver(Course course = Course::quickest);
  ~MicrobodySolver();
  /// As `simulate`, without peaks, balance and list of events; the result holds until the next call. Throws
  /// InvalidParameter for a body, accuracy or flow that makes no sense.
  const BriefMicrobodyImpact& solve(const model::Microbody& body, const hybrid::Options& options = {});

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace mariotte::impact
