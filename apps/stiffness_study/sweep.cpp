#include "sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <limits>
#include <optional>

#include "guard.hpp"
#include "mariotte/flow/choose.hpp"

namespace mariotte::stiffness_study {
namespace {

double error(const Run& run, const std::optional<Reference>& reference) {
  if (!run.separated() || !reference) return std::numeric_limits<double>::quiet_NaN();
  double largest = 0;
  for (std::size_t i = 0; i < run.velocity.size(); ++i)
    largest = std::max(largest, std::abs(run.velocity[i] - reference->velocity[i]));
  return largest;
}

/// Why a flow is not tried on the rest of a sweep; empty as long as it is.
std::string too_slow(const Run& run, double value, double patience) {
  if (run.ending == "-") return fmt::format("{} at {:g}", run.reason, value);
  if (run.seconds > patience) return fmt::format("took {:.2g} s at {:g}", run.seconds, value);
  return "";
}

}  // namespace

std::vector<std::string> flows(const Settings& settings, Index balls) {
  if (!settings.flow.empty()) return {settings.flow};
  std::vector<std::string> names = {"auto"};
  if (settings.quick && balls > 3) return names;
  for (const auto kind : flow::kinds)
    if (kind != flow::Kind::ballistic) names.emplace_back(flow::name(kind));
  return names;
}

Rows sweep(const Series& series, const std::vector<std::string>& flows, const Settings& settings,
           References& references) {
  Rows rows;
  for (const auto& flow : flows) {
    std::string slow;
    for (const auto& [value, one] : series.points) {
      progress(fmt::format("{}: {}, {}, at {:g}", series.study, series.name, flow, value));
      auto run = slow.empty() ? guarded(one,
                                        {.flow = flow,
                                         .accuracy = settings.accuracy,
                                         .longest = series.longest,
                                         .brief = series.brief,
                                         .batch = settings.batch()},
                                        settings.limit())
                              : Run{.ending = "-", .reason = slow};
      if (!run.admitted) continue;
      if (slow.empty()) slow = too_slow(run, value, settings.patience());
      const auto reference = run.separated() && one.side == 0
                                 ? references.find(one, run.flows, settings.accuracy)
                                 : std::nullopt;
      const double wrong = error(run, reference);
      rows.push_back({series.study, series.name, series.family, value, flow, settings.accuracy, one,
                      std::move(run), wrong, reference ? reference->source : "-"});
    }
  }
  return rows;
}

Rows sweep(const Series& series, const Settings& settings, References& references) {
  return sweep(series, flows(settings, series.points.front().impact_case.balls), settings, references);
}

std::vector<double> powers(double first, double last, double factor) {
  std::vector<double> values;
  const auto count = std::lround(std::log(last / first) / std::log(factor));
  for (long i = 0; i <= count; ++i) values.push_back(first * std::pow(factor, static_cast<double>(i)));
  return values;
}

void add(Rows& rows, Rows more) {
  rows.insert(rows.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

void progress(const std::string& what) {
  using Clock = std::chrono::steady_clock;
  static const auto start = Clock::now();
  static auto last = start;
  const auto now = Clock::now();
  if (now - start < std::chrono::seconds(2) || now - last < std::chrono::seconds(1)) return;
  last = now;
  std::fprintf(stderr, "stiffness_study: %s\n", what.c_str());
}

}  // namespace mariotte::stiffness_study
