// Measured oblique impacts of a sphere [Kharaz 2001].
#pragma once
#include "figure.hpp"

namespace mariotte::paper_figures {

/// Tangential restitution, spin and rebound angle against the angle of incidence.
std::vector<Figure> kharaz_oblique();

}  // namespace mariotte::paper_figures
