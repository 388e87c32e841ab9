#include "mariotte/hybrid/reached_limit.hpp"

#include <sstream>

namespace mariotte::hybrid {
namespace {

constexpr const char* after_limit = " was reached before the end";

}  // namespace

std::string reached_limit(Ending ending, const Options& options) {
  std::ostringstream text;
  if (ending == Ending::time_limit)
    text << (options.flies_on ? "until = " : "max_time = ") << options.max_time << " s";
  else if (ending == Ending::event_limit)
    text << "max_events = " << options.max_events;
  else
    return "";
  text << after_limit;
  return text.str();
}

bool tells_limit(std::string_view text) {
  return text.find(after_limit) != text.npos;
}

}  // namespace mariotte::hybrid
