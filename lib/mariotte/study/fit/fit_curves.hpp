// Restitution as fitted, along the setting that the measurements vary most, for a figure.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/study/fit/fit.hpp"

namespace mariotte::study {

/// Of all measurements that agree in the other settings.
struct FitCurve {
  std::string name;  ///< these settings as they were written; empty if there are none
  std::vector<double> abscissa = {}, ordinate = {};
  std::vector<bool> captured = {};
};

struct FitCurves {
  std::size_t setting = 0;  ///< whose values are the abscissa: the speed if it is one
  bool logarithmic = false;
  std::vector<FitCurve> curves = {};
  std::vector<std::size_t> curve_of_row = {};  ///< from 0
};

/// Empty if no setting is a number, or if there would be too many curves to tell apart.
std::optional<FitCurves> fit_curves(FitModel& model, const Fit& fit);

}  // namespace mariotte::study
