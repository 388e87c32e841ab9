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

/// Where forces can be seen.
struct Action {
  std::vector<Window> windows;  ///< one, or up to three
  std::vector<Window>
      strongest;            ///< up to three of many, or of brief ones, with the largest forces, else none
  std::size_t impacts = 1;  ///< so many are far apart
};

/// Windows lie beside each other where flights between them last several times longer than all that happens;
/// more than three are one. So is what pushes all the while, beside a few brief impacts. Faint late contacts,
/// below a thousandth of the largest force (in images, which show no more, a hundredth), and a long flight
/// before the first contact are left out.
Action action_of(const impact::Trace& trace);
Action action_of(const impact::BodyTrace& trace);
Action action_of(const impact::BodiesTrace& trace);

}  // namespace mariotte::report
