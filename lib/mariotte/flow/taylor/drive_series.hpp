// Drives in a step of the Taylor flow.
#pragma once
#include "mariotte/flow/taylor/taylor_window.hpp"

namespace mariotte::flow::taylor {

/// What drives do to lanes and velocities from the window's time on, before its lanes are expanded.
void expand_drives(Window& window, int order);
/// What work they do, once lanes are expanded.
void find_works(Window& window, const Expansion& lanes, int order);
/// How far the last coefficients of both keep to a tolerance: what drives move may have no contact, and a
/// contact may have none but walls, whose motion says nothing of its force.
double reach_of_drives(const Window& window, int order, double tolerance);

}  // namespace mariotte::flow::taylor
