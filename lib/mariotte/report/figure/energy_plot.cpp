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

/// Instead of the part around the contacts, in whose marks all that happens there would coincide here.
std::string whole_run(const EnergyCourse& course) {
  return fmt::format("unset label\nunset arrow\nunset object\nset xrange [0:time_factor*{:.8g}]\n",
                     course.time.back());
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
    if (chain.gravity == 0)
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

std::string energy_script(const EnergyCourse& course, const std::string& title, double shown_from) {
  const auto display = display_for(course.kinetic, "J");
  std::string draw = "plot ";
  constexpr std::array names = {"kinetic", "stored", "dissipated"};
  for (std::size_t k = 0; k < (course.lost.empty() ? 2u : 3u); ++k)
    draw += fmt::format(
        "{}'energy.csv' skip 1 using (time_factor*$1):({:g}*${}) with lines lw 2 lt {} title '{}'",
        k > 0 ? ", " : "", display.factor, k + 2, 2 * k + 1, names[k]);
  return (shown_from > 0 ? whole_run(course) : "") +
         fmt::format("\nset title {} noenhanced\nset ylabel 'energy [{}]'\nset key\nunset colorbox\n",
                     quoted(title.empty() ? "energy" : title + ": energy"), display.unit) +
         on_both_terminals("energy", draw + "\n");
}

}  // namespace mariotte::report
