// The parts of a run that its figures show.
#pragma once
#include <cstddef>
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"

namespace mariotte::report {

/// Of one figure; more are an image.
inline constexpr std::size_t most_curves = 12;

/// A part of a run [s].
struct Window {
  double start = 0;
  double end = 0;
};

/// Where forces can be seen: one window, or up to three beside each other where flights between them last
/// several times longer than all that happens. Faint late contacts, below a thousandth of the largest force
/// (in images, which show no more, a hundredth), and a long flight before the first contact are left out.
std::vector<Window> windows_of_action(const impact::Trace& trace);
std::vector<Window> windows_of_action(const impact::BodyTrace& trace);
std::vector<Window> windows_of_action(const impact::BodiesTrace& trace);

}  // namespace mariotte::report
