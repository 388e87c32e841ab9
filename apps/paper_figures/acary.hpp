// The figures of [Acary 2003].
#pragma once
#include "figure.hpp"

namespace mariotte::paper_figures {

/// Figure 1(a–h): contact forces in three balls over time.
std::vector<Figure> acary_forces();
/// Figure 2(a, b): impulse correlation ratios of chains.
std::vector<Figure> acary_ratios();
/// Figure 3(a, b): the multiple-impact law without energy loss.
std::vector<Figure> acary_law();

}  // namespace mariotte::paper_figures
