#include "mariotte/report/page/motion_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

namespace mariotte::report {
namespace {

constexpr std::size_t frames_of_window = 240, frames_of_flight = 24;

/// ∫ of all forces up to a time, and of their square.
struct Given {
  double time, force, sum, square;
};

/// At the ends of a window and at the samples within.
std::vector<Given> given_in(const Window& window, const std::vector<double>& sample, const Rows& force) {
  std::vector<Given> list;
  const auto add = [&](double time) {
    double all = 0;
    for (const double f : between(force, position(sample, time))) all += std::abs(f);
    if (list.empty()) return list.push_back({time, all, 0, 0});
    const auto before = list.back();
    const double step = time - before.time;
    list.push_back({time, all, before.sum + 0.5 * step * (all + before.force),
                    before.square + 0.5 * step * (all * all + before.force * before.force)});
  };
  add(window.start);
  for (const double time : sample)
    if (time > window.start && time < window.end) add(time);
  add(window.end);
  return list;
}

/// Forces last as long as their impulse would with its mean force; below this share of a window few of its
/// frames would show them.
constexpr double short_share = 0.2;

void add_frames(const Window& window, const std::vector<double>& sample, const Rows& force, std::size_t count,
                std::vector<double>& times) {
  const auto list = given_in(window, sample, force);
  const double length = window.end - window.start, all = list.back().sum;
  const double lasts = all > 0 ? all * all / list.back().square : length;
  const double by_force = lasts < short_share * length ? 0.5 : 0;
  const auto passed = [&](const Given& at) {
    return (1 - by_force) * (at.time - window.start) / length + (by_force > 0 ? by_force * at.sum / all : 0);
  };
  std::size_t next = 1;
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = static_cast<double>(i) / static_cast<double>(count);
    while (next + 1 < list.size() && passed(list[next]) < wanted) ++next;
    const double from = passed(list[next - 1]), span = passed(list[next]) - from;
    const double part = span > 0 ? std::clamp((wanted - from) / span, 0.0, 1.0) : 0;
    times.push_back(list[next - 1].time + part * (list[next].time - list[next - 1].time));
  }
}

/// Of the largest force that windows show.
std::optional<double> strongest_instant(const std::vector<Window>& windows, const std::vector<double>& sample,
                                        const Rows& force) {
  std::optional<double> found;
  double most = 0;
  for (std::size_t row = 0; row < sample.size(); ++row) {
    const auto shows = [&](const Window& w) { return w.start <= sample[row] && sample[row] <= w.end; };
    if (std::none_of(windows.begin(), windows.end(), shows)) continue;
    for (const double f : force[row])
      if (std::abs(f) > most) most = std::abs(f), found = sample[row];
  }
  return found;
}

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

std::vector<double> instants(const std::vector<Window>& windows, const std::vector<double>& sample,
                             const Rows& force) {
  std::vector<double> times;
  for (std::size_t k = 0; k < windows.size(); ++k) {
    if (k > 0) add_frames({windows[k - 1].end, windows[k].start}, sample, force, frames_of_flight, times);
    add_frames(windows[k], sample, force, frames_of_window / windows.size(), times);
  }
  times.push_back(windows.back().end);
  if (const auto most = strongest_instant(windows, sample, force)) times.push_back(*most);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
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
  Json all = {{"discs", Json::array()}, {"links", Json::array()},  {"floor", false},
              {"time", course.time},    {"move", Json::array()},   {"contacts", Json::array()},
              {"force", Json::array()}, {"planes", Json::array()}, {"outlines", Json::array()},
              {"to_scale", true}};
  const auto& first = course.place.front();
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const auto radius = discs[i].radius;
    all["discs"].push_back({{"x", first[2 * i]},
                            {"y", first[2 * i + 1]},
                            {"radius", std::isfinite(radius) ? Json(radius) : Json(nullptr)}});
  }
  for (const auto& one : contacts) {
    Json contact = {{"from", one.from}, {"to", one.to}, {"x", one.x}, {"y", one.y}};
    if (one.from < 0) contact["normal"] = {one.normal_x, one.normal_y};
    if (one.same_as >= 0) contact["same_as"] = one.same_as;
    all["contacts"].push_back(std::move(contact));
  }
  for (const auto& place : course.place) all["move"].push_back(rounded_row(place, first));
  for (const auto& force : course.force) all["force"].push_back(rounded_row(force));
  return all;
}

}  // namespace mariotte::report
