// Cost against length: this library on a ladder of lengths, and its rivals as far as they get.
#pragma once
#include <string>
#include <vector>

#include "measurement.hpp"

namespace mariotte::scaling_study {

struct Point {
  std::string method;
  std::size_t balls = 0;
  double accuracy = 0;  ///< asked for; 0 for rivals
  Measurement found;
  double own_seconds = 0;  ///< of rivals: our time at an error no larger than theirs
};

struct Settings {
  std::vector<double> accuracies;
  double longest = 1e6;  ///< balls
  double patience = 60;  ///< a rival that would take longer [s] is spared
};

/// Called as each point is found.
using Report = std::function<void(const Point&)>;

std::vector<Point> study_own(const Settings& settings, const Report& report);
std::vector<Point> study_rivals(const Settings& settings, const Report& report);

/// Slope of log time over log balls, by least squares, of points of one accuracy.
double growth_exponent(const std::vector<Point>& points, double accuracy);

std::string table(const std::vector<Point>& own);
std::string rival_table(const std::vector<Point>& rivals);
std::string csv(const std::vector<Point>& points);

}  // namespace mariotte::scaling_study
