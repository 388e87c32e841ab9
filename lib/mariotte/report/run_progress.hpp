// What a long run says of how far it is.
#pragma once
#include <string>

#include "mariotte/impact/watch/observers.hpp"

namespace mariotte::report {

/// "at 1.2 ms after 3 s, 4000 events; about 5 s more to the time limit" of a run that has `taken` [s] of
/// clock time so far. Nothing but a limit `max_time` [s] tells how long a run goes on, and only from a tenth
/// of it on: contacts are densest at the beginning.
std::string progress_text(const impact::Progress& progress, double max_time, double taken);

}  // namespace mariotte::report
