// How many balls a chain has, and where its walls stand.
#pragma once
#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// Walls made by `wall = …` are balls of the model, but the arrays of a scene list only the others.
struct Layout {
  Index cell = 0;    ///< balls that `repeat` repeats: what arrays of mass, radius and material speak of
  Index listed = 0;  ///< all balls that are no wall
  bool left = false;
  bool right = false;

  Index balls() const { return listed + left + right; }
  Index contacts() const { return balls() - 1; }
};

/// From `balls`, `repeat` and `wall`; without `balls`, from the first array that tells. Throws SceneError.
Layout read_layout(const Source& source, const Field& chain);

/// By arrays alone, where those keys are wrong, so that the rest can be looked at.
Layout guess_layout(const Field& chain);

/// Rejects an array that has not one value per listed ball, per ball of a cell, or per contact.
void expect_per_ball(const Source& source, const Field& array, const Layout& layout);
void expect_per_cell(const Source& source, const Field& array, const Layout& layout);
void expect_per_contact(const Source& source, const Field& array, const Layout& layout);

}  // namespace mariotte::scene
