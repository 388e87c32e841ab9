// What a sweep asks of one scene: the numbers of its result that stand in the columns.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "mariotte/study/sweep/columns.hpp"

namespace mariotte::study {

/// How one point ended.
struct Verdict {
  std::string ending = "separated";  ///< as in a result; "rejected" for a scene that makes no sense
  std::string reason = {};           ///< why there are no numbers, if there are none

  /// Whether the numbers mean something: the run ended by itself, or at a limit that the scene sets.
  bool has_numbers() const;
};

/// Fills in one number per column, nan where the result has none. Not to be shared between threads.
using Evaluate = std::function<Verdict(const scene::Scene&, std::span<double>)>;

/// Simulates scenes of any kind, by the quickest solver of their model if that has all the columns, and with
/// the same memory again and again.
Evaluate make_evaluate(const std::vector<Column>& columns);

/// The same of a point of a design.
using EvaluatePoint = std::function<Verdict(const scene::Scene&, Index point, std::span<double>)>;

struct SweepPlan;

/// Of a plan: the columns that are formulas, too. Not to be shared between threads, either.
EvaluatePoint make_evaluate_point(const SweepPlan& plan);

}  // namespace mariotte::study
