#include "run_notes.hpp"

#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/reason.hpp"

namespace mariotte::command {

void tell_ending(hybrid::Ending ending, const std::string& message, const scene::Scene& scene) {
  const auto why = report::reason(ending, message, scene);
  if (why.empty()) return;
  if (ending == hybrid::Ending::time_limit || ending == hybrid::Ending::interrupted) return warning(why);
  error(why, fault_of(ending));
}

}  // namespace mariotte::command
