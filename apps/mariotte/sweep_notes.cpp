#include "sweep_notes.hpp"

#include <fmt/format.h>

#include <ctime>

#include "command_line/terminal.hpp"

namespace mariotte::command {

void tell_cost(const study::Progress& progress, int threads, std::chrono::duration<double> taken) {
  if (progress.done == 0) return;
  const double each = 1e6 / static_cast<double>(progress.done);
  const double all = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  note(fmt::format(
      "{} points in {:.3g} s on {} threads; processor time of a point {:.3g} µs: simulation {:.3g}, "
      "rows and journal {:.3g}, the rest {:.3g}",
      progress.done, taken.count(), threads, each * all, each * progress.evaluating, each * progress.writing,
      each * (all - progress.evaluating - progress.writing)));
}

void tell_resumed(const study::SweepPlan& plan, const study::Journal& journal) {
  const Index points = plan.design.points(), left = total(journal.missing());
  if (left < points) note(fmt::format("{} of {} points were done before", points - left, points));
}

void tell_interrupted(const std::filesystem::path& folder, const study::SweepPlan& plan,
                      const study::Journal& journal) {
  const Index points = plan.design.points(), left = total(journal.missing());
  note(fmt::format("interrupted; {} of {} points are kept in {}, and the same command goes on from there",
                   points - left, points, folder.string()));
}

}  // namespace mariotte::command
