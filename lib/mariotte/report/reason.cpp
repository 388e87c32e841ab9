#include "mariotte/report/reason.hpp"

#include <fmt/format.h>

namespace mariotte::report {

std::string reason(const impact::ChainImpact& impact, const hybrid::Options& options) {
  using hybrid::Ending;
  if (!impact.message.empty()) return impact.message;
  switch (impact.ending) {
    case Ending::separated:
      return "";
    case Ending::time_limit:
      return fmt::format("max_time = {:g} s was reached before the end", options.max_time);
    case Ending::event_limit:
      return fmt::format("max_events = {} was reached before the end", options.max_events);
    case Ending::failed:
      return "the solver could not go on";
  }
  return "";
}

}  // namespace mariotte::report
