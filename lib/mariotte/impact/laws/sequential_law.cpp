#include "mariotte/impact/laws/sequential_law.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"

namespace mariotte::impact {
namespace {

using Numbers = std::vector<double>;

/// Impulses so far, and what they make of the gap rates.
class Collisions {
 public:
  Collisions(const Configuration& c, const SequentialOptions& options)
      : c_(c), options_(options), compliance_(compliance(c)), rates_(gap_rates(c, c.velocity)) {
    validate(c, options.restitution);
    impulse_.assign(rates_.size(), 0.0);
    for (const double rate : rates_) slow_ = std::max(slow_, rounding * std::abs(rate));
  }
  Index contacts() const { return std::ssize(rates_); }
  double rate(Index j) const { return rates_[j]; }
  bool closes(Index j) const { return rates_[j] < -slow_; }
  bool may_go_on() const { return count_ < options_.most_collisions; }

  void collide(Index j) {
    const double p = -(1 + options_.restitution[j]) * rates_[j] / compliance_[j * contacts() + j];
    impulse_[j] += p;
    for (Index i = 0; i < contacts(); ++i) rates_[i] += compliance_[j * contacts() + i] * p;
    ++count_;
  }
  LawOutcome outcome() const {
    auto outcome = outcome_of(c_, impulse_, 10 * rounding);  // of rates updated by every collision
    if (!may_go_on()) outcome.status = LawStatus::unfinished;
    outcome.steps = count_;
    return outcome;
  }

 private:
  const Configuration& c_;
  const SequentialOptions& options_;
  Numbers compliance_, rates_, impulse_;
  double slow_ = 0;
  long count_ = 0;
};

/// Time until contact j closes; ∞ if it does not.
double meeting(const Collisions& collisions, const Numbers& gap, Index j) {
  return collisions.closes(j) ? gap[j] / -collisions.rate(j) : infinity;
}

void validate_gaps(const Numbers& gap, Index contacts) {
  const auto positive = [](double g) { return g > 0 && std::isfinite(g); };
  if (std::ssize(gap) != contacts || !std::all_of(gap.begin(), gap.end(), positive))
    throw InvalidParameter("collisions by event need one positive gap per contact");
}

}  // namespace

LawOutcome left_to_right(const Configuration& c, const SequentialOptions& options) {
  Collisions collisions(c, options);
  bool any = true;
  while (any && collisions.may_go_on()) {
    any = false;
    for (Index j = 0; j < collisions.contacts(); ++j) {
      if (!collisions.closes(j)) continue;
      collisions.collide(j);
      any = true;
    }
  }
  return collisions.outcome();
}

LawOutcome by_event(const Configuration& c, const SequentialOptions& options, Numbers gap) {
  Collisions collisions(c, options);
  if (gap.empty()) gap.assign(collisions.contacts(), 1.0);
  validate_gaps(gap, collisions.contacts());
  while (collisions.may_go_on()) {
    Index first = 0;
    for (Index j = 1; j < collisions.contacts(); ++j)
      if (meeting(collisions, gap, j) < meeting(collisions, gap, first)) first = j;
    const double time = meeting(collisions, gap, first);
    if (time == infinity) break;
    for (Index j = 0; j < collisions.contacts(); ++j)
      gap[j] = std::max(0.0, gap[j] + time * collisions.rate(j));
    gap[first] = 0;
    collisions.collide(first);
  }
  return collisions.outcome();
}

}  // namespace mariotte::impact
