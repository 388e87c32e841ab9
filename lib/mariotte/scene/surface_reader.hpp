// `[surface]`: the plane that a microbody strikes, and the law of its tips.
#pragma once
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/scene/shape.hpp"

namespace mariotte::scene {

/// Throws SceneError for keys that are not known.
void expect_surface_keys(const Source& source, const Field& surface);

/// Laws of the tips and friction of a body that strikes at this normal speed [m/s]; returns the material of
/// the plane, if the scene gives it. Throws SceneError.
std::optional<Material> read_surface(Source& source, const Field& surface, const Shape& shape, double speed,
                                     model::Microbody& body);

/// Throws SceneError for what the surface has wrong, whatever strikes it.
void check_surface(Source& source, const Field& surface);

}  // namespace mariotte::scene
