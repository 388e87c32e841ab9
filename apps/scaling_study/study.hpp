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
  /// Of rivals: our time at an error no larger than theirs, and where every ball is followed.
  double own_seconds = 0, own_seconds_followed = 0;
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

/// Slope of log time over log balls, by least squares, of points of one method and accuracy.
double growth_exponent(const std::vector<Point>& points, const std::string& method, double accuracy);

/// Of this library: waves moved on, and followed.
inline const std::vector<std::string> own_methods = {"mariotte", "mariotte (followed)"};

std::string table(const std::vector<Point>& own);
std::string rival_table(const std::vector<Point>& rivals);
std::string csv(const std::vector<Point>& points);

}  // namespace mariotte::scaling_study
