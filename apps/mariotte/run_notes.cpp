#include "run_notes.hpp"

#include <fmt/format.h>

#include "command_line/terminal.hpp"
#include "mariotte/report/reason.hpp"

namespace mariotte::command {

ExitCode tell_ending(hybrid::Ending ending, const std::string& message, const scene::Scene& scene,
                     const std::string& where) {
  if (report::is_wanted(ending, scene)) return ExitCode::ok;
  const auto why = report::reason(ending, message, scene);
  if (ending == hybrid::Ending::time_limit || ending == hybrid::Ending::interrupted)
    warning(where + why);
  else if (!why.empty())
    error(where + why, fault_of(ending));
  return exit_code(ending);
}

std::vector<std::string> warnings(const scene::Impact& impact, const scene::Scene& scene) {
  return std::visit([&](const auto& one) { return report::warnings(one, scene.run.flow); }, impact);
}

void tell_warnings(const std::vector<std::string>& warnings, bool quiet, const std::string& where) {
  if (quiet) return;
  for (const auto& one : warnings) warning(where + one);
}

ExitCode tell_run(const scene::Impact& impact, const scene::Scene& scene, bool quiet,
                  const std::string& where) {
  tell_warnings(warnings(impact, scene), quiet, where);
  return std::visit([&](const auto& one) { return tell_ending(one.ending, one.message, scene, where); },
                    impact);
}

ExitCode tell_run_at(double speed, const scene::Scene& scene, bool quiet) {
  return tell_run(scene::simulate(scene), scene, quiet, fmt::format("at {:.6g} m/s: ", speed));
}

}  // namespace mariotte::command
