// What a moving picture of a run needs: discs, how they move, and the forces between them.
#pragma once
#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// `motion.json` of a run with a trace. In SI:
///   discs      {x, y, radius} at the first frame; radius null for a wall, which is a line across x
///   links      pairs of discs (from 0) that one body holds together
///   outlines   discs of one body, more than two, between which its outline is stretched
///   floor      whether the plane y = 0 is there
///   planes     {x, y, normal, speed}: other planes that stand across the picture, through (x, y) at t = 0,
///              and how fast they move along their normal
///   time       of each frame
///   move       a row per frame: x and y of every disc since the first frame
///   contacts   {from, to, x, y, normal, same_as}: the disc `from` (−1: a plane with that normal) pushes `to`
///              along the unit vector (x, y); `same_as` is the contact whose friction it is
///   force      a row per frame: a value per contact, negative if it pulls
///   to_scale   false if radii are not known, and discs are drawn as large as looks well
/// Frames show where forces can be seen, or `scene.figure.window`; long flights between are passed in few
/// frames, and short impacts in many. Balls in space are seen along z, bodies along e2. Empty for networks of
/// other than balls, for balls that no chain of contacts joins, and for more than 100 discs.
Json motion(const impact::ChainImpact& impact, const scene::Scene& scene);
Json motion(const impact::NetworkImpact& impact, const scene::Scene& scene);
Json motion(const impact::MicrobodyImpact& impact, const scene::Scene& scene);
Json motion(const impact::BodiesImpact& impact, const scene::Scene& scene);

}  // namespace mariotte::report
