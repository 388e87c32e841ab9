// Where numbers stand along the axes of figures.
#pragma once

namespace mariotte::report {

/// 1, 2 or 5 times a power of ten, so that at most `most` steps fit into `span`.
double tick_step(double span, double most);

}  // namespace mariotte::report
