// When contacts close and open, on the time axis of a figure.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/report/figure/window.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {

/// gnuplot commands for a time axis that shows `window` and is `width` pixels long. Up to 24 events have
/// lines and, where there is room, words in two rows above the figure; phases are shaded, the darker the more
/// contacts are closed. Of more events there are ticks. `with_words` is false where there is no room above.
std::string event_marks(const std::vector<impact::Event>& events, const Display& time, const Window& window,
                        double width, bool with_words = true);

}  // namespace mariotte::report
