#include "mariotte/report/reason.hpp"

#include "mariotte/hybrid/reached_limit.hpp"

namespace mariotte::report {

bool is_wanted(hybrid::Ending ending, const scene::Scene& scene) {
  return scene.until && ending == hybrid::Ending::time_limit;
}

std::string ending_name(hybrid::Ending ending, const scene::Scene& scene) {
  return std::string(hybrid::name(ending)) + (is_wanted(ending, scene) ? " (run.until)" : "");
}

std::string reason(hybrid::Ending ending, const std::string& message, const scene::Scene& scene) {
  if (is_wanted(ending, scene)) return "";
  return reason(ending, message, scene.run);
}

std::string reason(hybrid::Ending ending, const std::string& message, const hybrid::Options& options) {
  using hybrid::Ending;
  if (!message.empty()) return message;
  switch (ending) {
    case Ending::separated:
    case Ending::captured:
    case Ending::bound:
      return "";
    case Ending::time_limit:
    case Ending::event_limit:
      return reached_limit(ending, options);
    case Ending::interrupted:
      return "interrupted; this is what was computed until then";
    case Ending::unsure:
      return "the balances of the run do not close";
    case Ending::invalid:
      return "a contact is deeper than any contact law holds";
    case Ending::failed:
      return "the solver could not go on";
  }
  return "";
}

}  // namespace mariotte::report
