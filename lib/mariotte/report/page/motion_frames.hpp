// Frames of a moving picture: discs and forces at chosen instants.
#pragma once
#include <utility>
#include <vector>

#include "mariotte/report/figure/window.hpp"
#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

using Rows = std::vector<std::vector<double>>;

inline constexpr std::size_t most_discs = 100;

/// A ball, the end of a body, or a wall if the radius is infinite [m].
struct Disc {
  double x = 0, y = 0, radius = 0;
};

/// What pushes disc `to` along the unit vector (x, y): another disc, or a plane (−1) with this normal.
struct DiscContact {
  int from, to;
  double x, y;
  double normal_x = 0, normal_y = 1;
  int same_as = -1;  ///< the contact whose friction this is
};

/// x and y of every disc in turn [m], and the force of every contact [N], at the instants `time`.
struct Course {
  std::vector<double> time;
  Rows place, force;
};

/// Instants of the frames. Within a window they are even in time. Where forces act for a small part of it,
/// every second one is even in what they give, so that short impacts are seen. The largest force is a frame;
/// flights between windows have few. A row of forces at each sample.
std::vector<double> instants(const std::vector<Window>& windows, const std::vector<double>& sample,
                             const Rows& force);

/// The sample before an instant, and which part of the way to the next one it is; at least two samples.
std::pair<std::size_t, double> position(const std::vector<double>& times, double time);

/// Part of the way from one row to the next.
std::vector<double> between(const Rows& rows, const std::pair<std::size_t, double>& position);

/// The object that `motion` describes, on no floor and without links.
Json as_json(const std::vector<Disc>& discs, const std::vector<DiscContact>& contacts, const Course& course);

}  // namespace mariotte::report
