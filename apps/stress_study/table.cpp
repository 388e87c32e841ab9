#include "table.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mariotte/report/csv/columns.hpp"

namespace mariotte::stress_study {
namespace {

std::string share(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return "–";
  return fmt::format("{:.2f}", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

report::TableRow row(const Tally& t, const std::string& slow, const std::string& worst) {
  return {t.family,
          std::to_string(t.scenes),
          std::to_string(t.left_out),
          share(t.within[0], t.runs),
          share(t.within[1], t.runs),
          share(t.within[2], t.runs),
          share(t.naive, t.scenes),
          std::to_string(t.counts_differ),
          std::to_string(t.refusals),
          std::to_string(t.failures),
          std::to_string(t.killed),
          std::to_string(t.rivals),
          slow,
          fmt::format("{:.1f}", 1e3 * t.cost / std::max(1.0, static_cast<double>(t.scenes))),
          fmt::format("{:.1e}", t.worst),
          worst,
          std::to_string(t.unexplained)};
}

Tally sum(const std::vector<Tally>& tallies) {
  Tally all{.family = "all"};
  for (const auto& t : tallies) {
    all.scenes += t.scenes, all.left_out += t.left_out, all.naive += t.naive,
        all.counts_differ += t.counts_differ;
    all.failures += t.failures, all.killed += t.killed, all.refusals += t.refusals, all.rivals += t.rivals;
    all.unexplained += t.unexplained, all.runs += t.runs, all.cost += t.cost;
    for (int i = 0; i < 3; ++i) all.within[i] += t.within[i];
    if (t.worst > all.worst) all.worst = t.worst, all.worst_scene = t.worst_scene;
  }
  return all;
}

}  // namespace

void add(const Verdict& verdict, Tally& tally) {
  tally.cost += verdict.cost;
  tally.left_out += verdict.left_out;
  if (verdict.left_out) return;
  ++tally.scenes;
  tally.naive += verdict.naive;
  tally.counts_differ += verdict.counts_differ;
  tally.failures += verdict.failures > 0;
  tally.killed += verdict.killed > 0 || verdict.limits > 0;
  tally.refusals += verdict.refusals > 0;
  tally.rivals += verdict.rivals > 0;
  tally.unexplained += !verdict.findings.empty();
  for (const double error : verdict.error) {
    if (error < 0) continue;
    ++tally.runs;
    for (int i = 0; i < 3; ++i) tally.within[i] += error <= std::pow(10, i);
  }
  if (verdict.worst > tally.worst || (verdict.worst == tally.worst && verdict.scene < tally.worst_scene)) {
    tally.worst = verdict.worst;
    tally.worst_scene = verdict.scene;
  }
  if (verdict.seconds > 0) tally.seconds.push_back(static_cast<float>(verdict.seconds));
}

std::uint64_t slow(const Tally& tally) {
  if (tally.seconds.empty()) return 0;
  auto seconds = tally.seconds;
  const auto middle = seconds.begin() + std::ssize(seconds) / 2;
  std::nth_element(seconds.begin(), middle, seconds.end());
  const float most = 100 * *middle;
  return static_cast<std::uint64_t>(
      std::count_if(seconds.begin(), seconds.end(), [&](float one) { return one > most; }));
}

std::string table(const std::vector<Tally>& tallies) {
  const report::TableRow header = {"family",    "scenes",   "left out", "≤ 1× [%]", "≤ 10×",      "≤ 100×",
                                   "naive [%]", "counts",   "refused",  "failed",   "no end",     "rivals",
                                   "slow",      "CPU [ms]", "worst",    "scene",    "unexplained"};
  std::uint64_t all_slow = 0;
  std::vector<report::TableRow> rows;
  for (const auto& t : tallies) {
    if (t.scenes + t.left_out == 0) continue;
    all_slow += slow(t);
    rows.push_back(row(t, std::to_string(slow(t)), std::to_string(t.worst_scene)));
  }
  const auto all = sum(tallies);
  rows.push_back(row(all, std::to_string(all_slow), std::to_string(all.worst_scene)));
  return report::columns(header, std::ssize(rows), [&](Index i) { return rows[i]; });
}

}  // namespace mariotte::stress_study
