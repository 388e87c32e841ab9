// The contact laws and gaps of a chain.
#pragma once
#include <span>
#include <vector>

#include "mariotte/contact/law.hpp"
#include "mariotte/scene/balls.hpp"

namespace mariotte::scene {

/// One law per contact: what [[chain.contact]] does not say is taken from [chain], and a stiffness neither
/// gives from materials and radii. Throws SceneError.
std::vector<contact::Law> read_laws(const Source& source, const Field& chain, const Layout& layout,
                                    std::span<const Ball> balls);

/// Throws SceneError for what the laws alone have wrong, whatever the balls are.
void check_laws(const Source& source, const Field& chain, const Layout& layout);

/// Start gaps [m], 0 where the scene says nothing. Throws SceneError.
std::vector<double> read_gaps(const Source& source, const Field& chain, const Layout& layout,
                              bool precompressed);

}  // namespace mariotte::scene
