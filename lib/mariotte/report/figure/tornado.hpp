// Slopes as horizontal bars: a panel per outcome, the parameters that matter most to it on top.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/sensitivity.hpp"

namespace mariotte::report {

/// One bar: (p/y) ∂y/∂p of a parameter.
struct RelativeSlope {
  std::string parameter;
  double value;
};

/// The bars of an outcome, the longest first. None where outcome, parameter or slope is zero, or there is
/// none.
std::vector<RelativeSlope> relative_slopes(const impact::Sensitivity& slopes,
                                           const impact::OutcomeSlopes& outcome);

/// bars.csv: `panel`, `place` from the top, `slope` [% per %], `parameter`, for as many panels and bars as a
/// figure has room for.
std::string tornado_csv(const impact::Sensitivity& slopes);

/// plot.gp, which reads bars.csv in its folder; empty if there is no bar.
std::string tornado_script(const impact::Sensitivity& slopes, const std::string& title);

/// The figures that it makes.
std::vector<std::string> tornado_figures();

}  // namespace mariotte::report
