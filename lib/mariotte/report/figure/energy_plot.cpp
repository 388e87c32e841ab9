#include "mariotte/report/figure/energy_plot.hpp"

#include <fmt/format.h>

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

}  // namespace

EnergyCourse energy_course(const impact::Trace& trace, const model::Chain& chain) {
  EnergyCourse course{.time = trace.time, .kinetic = {}, .stored = {}, .lost = {}};
  for (std::size_t k = 0; k < trace.time.size(); ++k) {
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

std::string energy_script(const EnergyCourse& course, const std::string& title) {
  const auto display = display_for(course.kinetic, "J");
  std::string draw = "plot ";
  constexpr std::array names = {"kinetic", "stored", "dissipated"};
  for (std::size_t k = 0; k < (course.lost.empty() ? 2u : 3u); ++k)
    draw += fmt::format(
        "{}'energy.csv' skip 1 using (time_factor*$1):({:g}*${}) with lines lw 2 lt {} title '{}'",
        k > 0 ? ", " : "", display.factor, k + 2, 2 * k + 1, names[k]);
  return fmt::format("\nset title {} noenhanced\nset ylabel 'energy [{}]'\nset key\nunset colorbox\n",
                     quoted(title.empty() ? "energy" : title + ": energy"), display.unit) +
         on_both_terminals("energy", draw + "\n");
}

}  // namespace mariotte::report
