// Figures of a fit by gnuplot: measurements with the fitted curves, and what is left between the two.
#pragma once
#include <string>
#include <vector>

#include "mariotte/report/table/fit_report.hpp"
#include "mariotte/study/fit/fit_curves.hpp"

namespace mariotte::report {

/// What stands beside the axes, in gnuplot's enhanced text: of a setting, angles in degrees, and of what was
/// measured, as figures of sweeps call it.
std::string label_of(const study::Setting& setting);
std::string label_of(const study::Measurements& measurements);
/// Micrometres, which tables of measurements write "um", are "µm".
std::string name_of(const study::FitCurve& curve);

/// `curve`, the setting along which it goes [SI], `restitution`; curves count from 1.
/// An empty line, at which gnuplot ends a line, parts what is captured from what is not.
std::string curves_csv(const study::FitCurves& curves, const study::Measurements& measurements);

/// plot.gp, which reads points.csv and curves.csv in its folder.
std::string fit_script(const FitReport& report, const study::FitCurves& curves);

/// The figures that it makes.
std::vector<std::string> fit_figures();

}  // namespace mariotte::report
