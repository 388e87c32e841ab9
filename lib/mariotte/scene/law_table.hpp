// The points of a tabulated law, from a CSV file.
#pragma once
#include <vector>

#include "mariotte/contact/tabulated.hpp"
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// The columns `indentation [m]` and `force [N]` of the file that a key names, in any units; its path is
/// relative to the scene's folder. Throws SceneError and FileError.
std::vector<contact::LawPoint> read_law_table(const Source& source, const Field& path);

}  // namespace mariotte::scene
