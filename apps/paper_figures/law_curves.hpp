// Contact laws by their curves: what a pair of each does.
#pragma once
#include "figure.hpp"

namespace mariotte::paper_figures {

/// `law-forces-…` and `law-restitution-…`, for laws with dampers, that yield, and that adhere.
std::vector<Figure> law_curves();

}  // namespace mariotte::paper_figures
