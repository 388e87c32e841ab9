#include "study.hpp"

#include <algorithm>
#include <cmath>

#include "method.hpp"

namespace mariotte::scaling_study {
namespace {

Point beside_own(const Rival& rival, std::size_t balls) {
  Point point{.method = rival.name, .balls = balls, .found = measured([&] { return rival.measure(balls); })};
  const double accuracy = std::clamp(point.found.error, 1e-13, 0.1);
  const auto own = [&](Wave wave) {
    return measured([&] { return measure_own(balls, accuracy, wave); }).seconds;
  };
  point.own_seconds = own(Wave::moved_on);
  point.own_seconds_followed = own(Wave::followed);
  return point;
}

}  // namespace

std::vector<Point> study_own(const Settings& settings, const Report& report) {
  std::vector<Point> points;
  for (const auto wave : {Wave::moved_on, Wave::followed})
    for (const double accuracy : settings.accuracies)
      for (double n = 100; n < 1.01 * settings.longest; n *= 10) {
        const auto balls = static_cast<std::size_t>(std::round(n));
        points.push_back({.method = own_methods[wave == Wave::followed],
                          .balls = balls,
                          .accuracy = accuracy,
                          .found = measured([&] { return measure_own(balls, accuracy, wave); })});
        report(points.back());
      }
  return points;
}

std::vector<Point> study_rivals(const Settings& settings, const Report& report) {
  std::vector<Point> points;
  for (const auto& rival : rivals()) {
    Measurement last;
    for (std::size_t balls = 125; static_cast<double>(balls) < 1.01 * settings.longest; balls *= 2) {
      if (4 * last.seconds > settings.patience) break;  // every ball at every step: n²
      points.push_back(beside_own(rival, balls));
      last = points.back().found;
      report(points.back());
    }
  }
  return points;
}

double growth_exponent(const std::vector<Point>& points, const std::string& method, double accuracy) {
  double count = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& point : points) {
    if (point.method != method || point.accuracy != accuracy) continue;
    const double length = std::log(static_cast<double>(point.balls)), time = std::log(point.found.seconds);
    count += 1, x += length, y += time, xx += length * length, xy += length * time;
  }
  return (count * xy - x * y) / (count * xx - x * x);
}

}  // namespace mariotte::scaling_study
