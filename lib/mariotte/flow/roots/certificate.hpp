// Proof that a step has passed no event: a sign change between the ends of a step misses contacts shorter
// than it.
#pragma once
#include <optional>
#include <vector>

#include "mariotte/flow/flow.hpp"

namespace mariotte::flow {

/// A guard's value and rate at one time.
struct GuardPoint {
  double time;
  double value;
  double rate;
};

/// True if the cubic through both points with both rates does not fall below zero between them: its two inner
/// Bernstein coefficients are not negative. The ends may be a rounding error below, as they are where a guard
/// has just left zero and where it fires.
bool keeps_side(const GuardPoint& from, const GuardPoint& to);

/// True if that cubic stays below zero: such a guard has to come back before it can fire.
bool stays_beyond(const GuardPoint& from, const GuardPoint& to);

/// A guard that crosses inside a step.
struct HiddenCrossing {
  Index guard;
  double time;
};

/// Looks into accepted steps for guards that cross and come back.
class Certificate {
 public:
  /// Begin at x, or begin anew where what is watched has changed.
  void begin(const Problem& problem, ConstState x);
  /// The first crossing in (step.start, step.end) of a guard whose sign is the same at both ends; empty if
  /// every guard provably keeps its side. The cubic of each guard decides nearly always; where it does not,
  /// the step's dense output is bisected until it does. Must be called for each step in turn.
  std::optional<HiddenCrossing> examine(const Problem& problem, const Step& step);

 private:
  std::optional<double> search(const Problem& problem, const Step& step, Index guard, const GuardPoint& from,
                               const GuardPoint& to, int depth);
  GuardPoint point(const Problem& problem, const Step& step, Index guard, double time);
  void evaluate(const Problem& problem, ConstState x, std::vector<double>& values,
                std::vector<double>& rates);

  std::vector<double> value_, rate_, next_value_, next_rate_;
  std::vector<double> x_, dx_, inner_value_, inner_rate_;
  int bisections_ = 0;
};

}  // namespace mariotte::flow
