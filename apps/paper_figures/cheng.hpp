// The figures of [Cheng 2002].
#pragma once
#include "figure.hpp"

namespace mariotte::paper_figures {

/// Figure 7: restitution of spheres against speed.
std::vector<Figure> cheng_spheres();
/// Figures 8–10: restitution of dumbbells and rods against length and tilt.
std::vector<Figure> cheng_shapes();
/// Figures 11–15: velocities and forces during the contact of rods.
std::vector<Figure> cheng_histories();

}  // namespace mariotte::paper_figures
