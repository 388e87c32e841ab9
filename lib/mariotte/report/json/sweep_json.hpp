// A sweep as a whole, for scripts and for its page.
#pragma once
#include <istream>

#include "mariotte/report/json/json.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"

namespace mariotte::report {

/// What was varied, what was asked for, and how many points there are; `failed` of them have no numbers.
Json json(const study::SweepPlan& plan, Index failed);

/// What the sweep.csv of a sweep holds: `columns` with their number of numbers, the least and the greatest;
/// `endings` with their number of points; `reasons` of points that have no numbers or ended at a limit, the
/// commonest first, each with its number of points and its first row. Rows are counted from 1.
Json summary(std::istream& csv);

}  // namespace mariotte::report
