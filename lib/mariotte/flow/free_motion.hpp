// Motion in which nothing touches, in closed form.
#pragma once
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::flow {

/// What a flow needs of bodies in free flight; they know their gaps and how they turn.
class FreeMotion {
 public:
  virtual ~FreeMotion() = default;
  /// First t > 0 at which a gap falls through zero, up to `limit`; infinite if there is none. No meeting is
  /// missed. The guards of all that meet then, within `window`, are appended to `fired`.
  virtual double first_meeting(ConstState x, double limit, double window,
                               std::vector<Index>& fired) const = 0;
  /// The state after time t.
  virtual void fly(ConstState x, double t, State result) const = 0;
};

}  // namespace mariotte::flow
