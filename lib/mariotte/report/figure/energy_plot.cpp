#include "mariotte/report/figure/energy_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

// The sample at the end of a period has its time but for rounding, and forces that are not quite zero.
constexpr double past_rounding = 1 + 8 * std::numeric_limits<double>::epsilon();

/// Whether one of the periods, which are in order, has begun at a time and not ended.
bool carries_force(const std::vector<impact::Period>& periods, double time) {
  const auto begins_later = [](double at, const impact::Period& one) { return at < one.start; };
  const auto next = std::upper_bound(periods.begin(), periods.end(), time * past_rounding, begins_later);
  if (next == periods.begin()) return false;
  const auto& end = std::prev(next)->end;
  return !end || time * past_rounding < *end;
}

/// A contact that is indented without force has lost what it stored.
double stored(const impact::ChainImpact& impact, std::size_t row, const model::Chain& chain) {
  const auto& gap = impact.trace.gap[row];
  double sum = 0;
  for (std::size_t j = 0; j < gap.size(); ++j)
    if (gap[j] < 0 && carries_force(impact.contacts[j].periods, impact.trace.time[row]))
      sum += contact::stored_energy(chain.law[j], -gap[j]);
  return sum;
}

/// Kinetic energies between two rows without force: velocities are linear in time, and energies need not be.
void sample_flight(const impact::Trace& trace, std::size_t row, const model::Chain& chain,
                   EnergyCourse& course) {
  constexpr int pieces = 32;
  const auto& before = trace.velocity[row - 1];
  auto velocity = before;
  for (int i = 1; i < pieces; ++i) {
    const double part = static_cast<double>(i) / pieces;
    for (std::size_t k = 0; k < velocity.size(); ++k)
      velocity[k] = before[k] + part * (trace.velocity[row][k] - before[k]);
    course.time.push_back(trace.time[row - 1] + part * (trace.time[row] - trace.time[row - 1]));
    course.kinetic.push_back(kinetic_energy(chain, velocity));
    course.stored.push_back(0);
  }
}

bool flies(const impact::Trace& trace, std::size_t row) {
  const auto zero = [](double force) { return force == 0; };
  return std::all_of(trace.force[row].begin(), trace.force[row].end(), zero);
}

/// Whether gravity, drives or moving walls do work, which the samples do not show.
bool takes_work(const model::Chain& chain) {
  bool moves = false;
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    moves = moves || (std::isinf(chain.mass[i]) && chain.velocity[i] != 0);
  return moves || chain.gravity != 0 || !chain.drive.empty();
}

}  // namespace

bool knows_energies(const model::Chain& chain) {
  const auto remembers = [](const contact::Law& law) { return contact::branched(law) != nullptr; };
  return std::none_of(chain.law.begin(), chain.law.end(), remembers);
}

EnergyCourse energy_course(const impact::ChainImpact& impact, const model::Chain& chain) {
  const auto& trace = impact.trace;
  const bool is_closed = !takes_work(chain);
  EnergyCourse course;
  for (std::size_t k = 0; k < trace.time.size(); ++k) {
    if (k > 0 && chain.gravity != 0 && flies(trace, k - 1) && flies(trace, k))
      sample_flight(trace, k, chain, course);
    course.time.push_back(trace.time[k]);
    course.kinetic.push_back(kinetic_energy(chain, trace.velocity[k]));
    course.stored.push_back(stored(impact, k, chain));
    if (is_closed)
      course.lost.push_back(course.kinetic[0] + course.stored[0] - course.kinetic[k] - course.stored[k]);
  }
  return course;
}

std::string energy_csv(const EnergyCourse& course) {
  std::string text = "time [s],kinetic [J],stored [J],dissipated [J]\n";
  for (std::size_t k = 0; k < course.time.size(); ++k) {
    for (const double value : {course.time[k], course.kinetic[k], course.stored[k]})
      (text += exact(value)) += ',';
    text += (course.lost.empty() ? "" : exact(course.lost[k])) + "\n";
  }
  return text;
}

std::string energy_script(const EnergyCourse& course, const std::string& title, TimeAxis axis) {
  TimeFigure figure{"energy", title, "energy E", "J", Names::at_end, course.time, {}};
  const auto add = [&](const char* name, int column, const std::vector<double>& value) {
    figure.curves.push_back({name, "'energy.csv' skip 1", 1, column, value});
  };
  add("kinetic", 2, course.kinetic);
  add("stored", 3, course.stored);
  if (!course.lost.empty()) add("dissipated", 4, course.lost);
  if (const double start = axis.windows.front().start; start > 0 && !axis.is_chosen)
    axis.windows.insert(axis.windows.begin(), {0, start});
  return script(figure, axis);
}

}  // namespace mariotte::report
