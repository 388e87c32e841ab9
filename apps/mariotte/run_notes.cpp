#include "run_notes.hpp"

#include <fmt/format.h>

#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/reason.hpp"

namespace mariotte::command {

void warn_of_error(double estimated, double requested) {
  warning(
      fmt::format("velocities may be wrong by {:.1e} of the largest speed, where {:g} was asked: "
                  "contacts close so often that errors grow",
                  estimated, requested));
}

void warn_of_nothing(const impact::ContactImpact& impact) {
  if (impact.events.empty() && impact.ending == hybrid::Ending::separated)
    warning("nothing collides: no contact ever closes");
}

void tell_ending(hybrid::Ending ending, const std::string& message, const scene::Scene& scene) {
  const auto why = report::reason(ending, message, scene);
  if (why.empty()) return;
  if (ending == hybrid::Ending::time_limit) return warning(why);
  error(why, fault_of(ending));
}

}  // namespace mariotte::command
