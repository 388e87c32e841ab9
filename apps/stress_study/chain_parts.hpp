// Random chains, drawn in units of order one.
#pragma once
#include "draw.hpp"
#include "scene.hpp"

namespace mariotte::stress_study {

/// n balls with masses and contacts, touching and at rest.
model::Chain draw_row(Dice& dice, int balls, Laws laws);

/// The same with masses and stiffnesses over so many powers of ten.
model::Chain draw_row(Dice& dice, int balls, Laws laws, double mass_decades, double stiffness_decades);

/// Gaps on some of the contacts, up to `most`.
void draw_gaps(Dice& dice, model::Chain& chain, double share, double most);

/// Velocities between −1 and 1.
void draw_velocities(Dice& dice, model::Chain& chain);

/// A ball of infinite mass at the left or right end, with a contact like that of its neighbour.
void add_wall(model::Chain& chain, bool left, double gap = 0, double velocity = 0);

/// Longest of the natural times of the contacts when struck at unit speed [s].
double natural_time(const model::Chain& chain);

/// The chain in other units of mass, length and time, so that its numbers are of any size; `time` in the old.
Scene in_some_units(Dice& dice, model::Chain chain, double max_time = infinity);

}  // namespace mariotte::stress_study
