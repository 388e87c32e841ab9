#include <fmt/format.h>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"
#include "study.hpp"

namespace mariotte::scaling_study {
namespace {

double per_ball(const Point& point, double amount) {
  return amount / static_cast<double>(point.balls);
}

}  // namespace

std::string table(const std::vector<Point>& own) {
  const report::TableRow header = {"balls",      "asked for", "error",      "time [ms]", "µs/ball",
                                   "steps/ball", "widest",    "bytes/ball", "method"};
  return report::columns(header, std::ssize(own), [&](Index i) -> report::TableRow {
    const auto& point = own[static_cast<std::size_t>(i)];
    const auto& found = point.found;
    return {std::to_string(point.balls),
            fmt::format("{:.0e}", point.accuracy),
            fmt::format("{:.0e}", found.error),
            fmt::format("{:.3g}", 1e3 * found.seconds),
            fmt::format("{:.2f}", per_ball(point, 1e6 * found.seconds)),
            fmt::format("{:.2f}", per_ball(point, static_cast<double>(found.steps))),
            std::to_string(found.widest),
            fmt::format("{:.0f}", per_ball(point, found.bytes)),
            point.method};
  });
}

std::string rival_table(const std::vector<Point>& rivals) {
  const report::TableRow header = {"method",     "balls",      "error",     "time [ms]",
                                   "bytes/ball", "× mariotte", "× followed"};
  return report::columns(header, std::ssize(rivals), [&](Index i) -> report::TableRow {
    const auto& point = rivals[static_cast<std::size_t>(i)];
    const auto& found = point.found;
    return {point.method,
            std::to_string(point.balls),
            fmt::format("{:.0e}", found.error),
            fmt::format("{:.3g}", 1e3 * found.seconds),
            fmt::format("{:.0f}", per_ball(point, found.bytes)),
            fmt::format("{:.3g}", found.seconds / point.own_seconds),
            fmt::format("{:.3g}", found.seconds / point.own_seconds_followed)};
  });
}

std::string csv(const std::vector<Point>& points) {
  std::string text =
      "method,balls,accuracy,error,time [s],steps,widest,memory [B],own time [s],followed [s]\n";
  for (const auto& [method, balls, accuracy, found, own, followed] : points)
    text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", method, balls, report::exact(accuracy),
                        report::exact(found.error), report::exact(found.seconds), found.steps, found.widest,
                        report::exact(found.bytes), report::exact(own), report::exact(followed));
  return text;
}

}  // namespace mariotte::scaling_study
