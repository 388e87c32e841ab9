// A fit for people and for scripts.
#pragma once
#include <optional>
#include <string>

#include "mariotte/report/json/json.hpp"
#include "mariotte/study/fit/fit_curves.hpp"

namespace mariotte::report {

/// What was fitted to what.
struct FitReport {
  const study::Fit& fit;
  const study::Measurements& measurements;
  std::string title;         ///< of the scene
  std::string scene_sha256;  ///< for provenance
};

/// The values with their errors, how they depend on each other, and the residuals.
std::string table(const FitReport& report);

/// The same in full precision. A deviation that was not given is null.
Json json(const FitReport& report);

/// `line`, the settings in SI, `measured,deviation,predicted,residual,captured,curve`: with units, one row
/// per measurement; the curve of the figure, from 1, is left empty where there is no figure.
std::string points_csv(const FitReport& report, const std::optional<study::FitCurves>& curves);

}  // namespace mariotte::report
