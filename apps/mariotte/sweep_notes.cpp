#include "sweep_notes.hpp"

#include <fmt/format.h>

#include <ctime>

#include "command_line/terminal.hpp"
#include "mariotte/core/counted.hpp"

namespace mariotte::command {

void tell_cost(const study::Progress& progress, int threads, std::chrono::duration<double> taken) {
  if (progress.done == 0) return;
  const double each = 1e6 / static_cast<double>(progress.done);
  const double all = static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  note(
      fmt::format("{} in {:.3g} s on {}; processor time of a point {:.3g} µs: simulation {:.3g}, "
                  "rows and journal {:.3g}, the rest {:.3g}",
                  counted(progress.done, "point"), taken.count(), counted(threads, "thread"), each * all,
                  each * progress.evaluating, each * progress.writing,
                  each * (all - progress.evaluating - progress.writing)));
}

void tell_resumed(const study::SweepPlan& plan, const study::Journal& journal) {
  const Index points = plan.design.points(), left = total(journal.missing());
  if (left < points)
    note(fmt::format("{} of {} {} done before", points - left, counted(points, "point"),
                     points - left == 1 ? "was" : "were"));
}

void tell_interrupted(const std::filesystem::path& folder, const study::SweepPlan& plan,
                      const study::Journal& journal) {
  const Index points = plan.design.points(), left = total(journal.missing());
  note(fmt::format("interrupted; {} of {} kept in {}, and the same command goes on from there", points - left,
                   counted(points, "point"), folder.string()));
}

}  // namespace mariotte::command
