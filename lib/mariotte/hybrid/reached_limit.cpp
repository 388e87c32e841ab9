#include "mariotte/hybrid/reached_limit.hpp"

#include <sstream>

namespace mariotte::hybrid {

std::string reached_limit(Ending ending, const Options& options) {
  std::ostringstream text;
  if (ending == Ending::time_limit)
    text << (options.flies_on ? "until = " : "max_time = ") << options.max_time << " s";
  else if (ending == Ending::event_limit)
    text << "max_events = " << options.max_events;
  else
    return "";
  text << " was reached before the end";
  return text.str();
}

}  // namespace mariotte::hybrid
