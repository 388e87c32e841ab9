#include "run_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/reason.hpp"
#include "mariotte/report/validity.hpp"

namespace mariotte::command {

void warn_of_error(double estimated, double requested, const char* why) {
  warning(fmt::format("velocities may be wrong by {:.1e} of the largest speed, where {:g} was asked: {}",
                      estimated, requested, why));
}

const char* why_inaccurate(const impact::BodiesImpact& impact) {
  const bool again = std::any_of(impact.contacts.begin(), impact.contacts.end(),
                                 [](const auto& contact) { return contact.periods.size() > 1; });
  return again ? "contacts close so often that errors grow"
               : "indentations are so small beside the way to the first contact that digits are lost";
}

namespace {

template <class Impact>
void warn_if_nothing(const Impact& impact) {
  if (impact.events.empty() && impact.ending == hybrid::Ending::separated)
    warning("nothing collides: no contact ever closes");
}

}  // namespace

void warn_of_nothing(const impact::ContactImpact& impact) {
  warn_if_nothing(impact);
}
void warn_of_nothing(const impact::BodiesImpact& impact) {
  warn_if_nothing(impact);
}

void warn_of_limits(const impact::ContactImpact& impact) {
  for (const auto& one : report::warnings(impact.validity, "contact")) warning(one);
}
void warn_of_limits(const impact::BodiesImpact& impact) {
  for (const auto& one : report::warnings(impact.validity, "contact")) warning(one);
}
void warn_of_limits(const impact::MicrobodyImpact& impact) {
  for (const auto& one : report::warnings(impact.validity, "tip")) warning(one);
}

void tell_ending(hybrid::Ending ending, const std::string& message, const scene::Scene& scene) {
  const auto why = report::reason(ending, message, scene);
  if (why.empty()) return;
  if (ending == hybrid::Ending::time_limit || ending == hybrid::Ending::interrupted) return warning(why);
  error(why, fault_of(ending));
}

}  // namespace mariotte::command
