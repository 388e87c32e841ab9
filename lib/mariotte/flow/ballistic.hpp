// Free flight: closed form, nothing is integrated.
#pragma once
#include <vector>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/roots/simultaneous.hpp"

namespace mariotte::flow {

/// Smallest t > 0 at which value + rate t + bend t²/2 crosses zero the given way; infinite if it never does.
/// A value of zero at t = 0 is not a crossing. No intermediate overflows unless the answer does.
double first_crossing(Crossing crossing, double value, double rate, double bend);

/// x(t) = x + t x' + t²/2 x'' up to the first crossing of a guard.
class Ballistic final : public Flow {
 public:
  bool admits(const Problem& problem) override { return problem.is_ballistic(); }
  Arrival follow(Problem& problem, State x, const Request& request, std::vector<Index>& fired) override;

 private:
  double next_crossing(const Problem& problem, ConstState x, Index& guard);
  double land(const Problem& problem, State x, Index guard, double flight);

  Simultaneous simultaneous_;
  std::vector<double> start_, rate_, bend_, value_, value_rate_, value_bend_;
};

}  // namespace mariotte::flow
