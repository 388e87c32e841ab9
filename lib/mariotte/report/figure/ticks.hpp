// Where numbers stand along the axes of figures.
#pragma once
#include <string>
#include <vector>

namespace mariotte::report {

/// 1, 2 or 5 times a power of ten, so that at most `most` steps fit into `span`.
double tick_step(double span, double most);

/// Round numbers from `least` to `most` along a logarithmic axis that has room for so many letters: up to
/// five in every decade, or one in some decades; even steps where the ends are too near each other.
std::vector<double> logarithmic_ticks(double least, double most, double letters);

/// Six digits at most, with a minus that is no hyphen, as gnuplot writes beside its own ticks.
std::string tick_name(double value);

}  // namespace mariotte::report
