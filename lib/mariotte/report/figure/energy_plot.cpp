#include "mariotte/report/figure/energy_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

/// A contact that is indented without force has lost what it stored.
double stored(const model::Chain& chain, const std::vector<double>& gap, const std::vector<double>& force) {
  double sum = 0;
  for (std::size_t j = 0; j < gap.size(); ++j)
    if (force[j] > 0 && gap[j] < 0) sum += contact::stored_energy(chain.law[j], -gap[j]);
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

}  // namespace

EnergyCourse energy_course(const impact::Trace& trace, const model::Chain& chain) {
  EnergyCourse course;
  for (std::size_t k = 0; k < trace.time.size(); ++k) {
    if (k > 0 && chain.gravity != 0 && flies(trace, k - 1) && flies(trace, k))
      sample_flight(trace, k, chain, course);
    course.time.push_back(trace.time[k]);
    course.kinetic.push_back(kinetic_energy(chain, trace.velocity[k]));
    course.stored.push_back(stored(chain, trace.gap[k], trace.force[k]));
    if (chain.gravity == 0 && chain.drive.empty())
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
