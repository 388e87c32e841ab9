#include "mariotte/report/reason.hpp"

#include <fmt/format.h>

namespace mariotte::report {

std::string reason(hybrid::Ending ending, const std::string& message, const hybrid::Options& options) {
  using hybrid::Ending;
  if (!message.empty()) return message;
  switch (ending) {
    case Ending::separated:
    case Ending::captured:
      return "";
    case Ending::time_limit:
      return fmt::format("max_time = {:g} s was reached before the end", options.max_time);
    case Ending::event_limit:
      return fmt::format("max_events = {} was reached before the end", options.max_events);
    case Ending::unsure:
      return "the balances of the run do not close";
    case Ending::failed:
      return "the solver could not go on";
  }
  return "";
}

}  // namespace mariotte::report
