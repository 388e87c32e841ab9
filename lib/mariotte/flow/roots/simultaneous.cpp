#include "mariotte/flow/roots/simultaneous.hpp"

#include <algorithm>

namespace mariotte::flow {
namespace {

bool fires(Crossing crossing, double now, double soon) {
  if (crossing == Crossing::falling) return soon <= 0 && soon < now;
  if (crossing == Crossing::rising) return soon >= 0 && soon > now;
  return false;
}

}  // namespace

void Simultaneous::collect(const Problem& problem, ConstState x, double window, std::vector<Index>& fired) {
  slope_.resize(x.size());
  ahead_.resize(x.size());
  const Index count = problem.guard_count();
  now_.resize(count);
  soon_.resize(count);
  problem.derivative_and_guards(x, slope_, now_);
  for (std::size_t i = 0; i < x.size(); ++i) ahead_[i] = x[i] + window * slope_[i];
  problem.guards(ahead_, soon_);
  const auto crossings = problem.crossings();
  for (Index i = 0; i < count; ++i) {
    if (!fires(crossings[i], now_[i], soon_[i])) continue;
    if (std::find(fired.begin(), fired.end(), i) == fired.end()) fired.push_back(i);
  }
}

}  // namespace mariotte::flow
