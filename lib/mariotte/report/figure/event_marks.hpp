// When contacts close and open, on the time axis of a figure.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/report/figure/window.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {

/// gnuplot commands for a time axis that shows `window` and is `width` pixels long. Up to 24 events have
/// lines and words in two rows above the figure, which may go `room` pixels beyond its right end; events too
/// near to each other share their words, and without `room` there are none. Phases are shaded, the darker the
/// more contacts are closed. Of more events there are ticks.
std::string event_marks(const std::vector<impact::Event>& events, const Display& time, const Window& window,
                        double width, std::optional<double> room = {});

/// The same above an image, which lines would hide: ticks alone.
std::string event_ticks(const std::vector<impact::Event>& events, const Display& time, const Window& window,
                        double width);

}  // namespace mariotte::report
