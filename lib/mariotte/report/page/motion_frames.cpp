#include "mariotte/report/page/motion_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace mariotte::report {
namespace {

constexpr std::size_t frames_of_window = 240, frames_of_flight = 24;

/// Five digits, which no screen shows.
Json rounded_row(const std::vector<double>& row, const std::vector<double>& origin = {}) {
  auto list = Json::array();
  for (std::size_t k = 0; k < row.size(); ++k) {
    const double value = row[k] - (origin.empty() ? 0 : origin[k]);
    list.push_back(value == 0 ? 0.0 : std::stod(fmt::format("{:.5g}", value)));
  }
  return list;
}

}  // namespace

std::vector<double> instants(const std::vector<Window>& windows) {
  std::vector<double> times;
  const auto add = [&](double from, double to, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
      times.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(count));
  };
  for (std::size_t k = 0; k < windows.size(); ++k) {
    if (k > 0) add(windows[k - 1].end, windows[k].start, frames_of_flight);
    add(windows[k].start, windows[k].end, frames_of_window / windows.size());
  }
  times.push_back(windows.back().end);
  return times;
}

std::pair<std::size_t, double> position(const std::vector<double>& times, double time) {
  const auto next = std::upper_bound(times.begin(), times.end(), time) - times.begin();
  const auto i = std::clamp<std::size_t>(static_cast<std::size_t>(next), 1, times.size() - 1);
  const double span = times[i] - times[i - 1];
  return {i - 1, span > 0 ? std::clamp((time - times[i - 1]) / span, 0.0, 1.0) : 1};
}

std::vector<double> between(const Rows& rows, const std::pair<std::size_t, double>& position) {
  const auto [before, part] = position;
  auto row = rows[before];
  for (std::size_t k = 0; k < row.size(); ++k) row[k] += part * (rows[before + 1][k] - row[k]);
  return row;
}

Json as_json(const std::vector<Disc>& discs, const std::vector<DiscContact>& contacts, const Course& course) {
  Json all = {{"discs", Json::array()}, {"links", Json::array()}, {"floor", false},
              {"time", course.time},    {"move", Json::array()},  {"contacts", Json::array()},
              {"force", Json::array()}, {"to_scale", true}};
  const auto& first = course.place.front();
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const auto radius = discs[i].radius;
    all["discs"].push_back({{"x", first[2 * i]},
                            {"y", first[2 * i + 1]},
                            {"radius", std::isfinite(radius) ? Json(radius) : Json(nullptr)}});
  }
  for (const auto& one : contacts)
    all["contacts"].push_back({{"from", one.from}, {"to", one.to}, {"x", one.x}, {"y", one.y}});
  for (const auto& place : course.place) all["move"].push_back(rounded_row(place, first));
  for (const auto& force : course.force) all["force"].push_back(rounded_row(force));
  return all;
}

}  // namespace mariotte::report
