// Words on events above a time axis.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/report/figure/window.hpp"

namespace mariotte::report {

/// gnuplot commands for words in two rows on all of these events, which lie in `window`; those too near to
/// each other share their words. The axis is `width` pixels long, and words may go `room` pixels beyond its
/// end.
std::string event_words(const std::vector<impact::Event>& events, const Window& window, double width,
                        double room);

}  // namespace mariotte::report
