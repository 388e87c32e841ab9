// The size of a sphere: 'radius', or 'diameter', of which it is half.
#pragma once
#include <optional>

#include "mariotte/scene/field.hpp"

namespace mariotte::scene {

/// A radius that is larger than `most` [m] looks like a slip, of which `warning` tells.
struct LargeRadius {
  double most;
  const char* warning;
};
inline constexpr LargeRadius large_body{1, "a radius of more than 1 m (a bare number is in metres)"},
    large_microbody{1e-3, "a radius of more than 1 mm is no microbody's (a bare number is in metres)"};

double read_radius(Source& source, const Field& field, const LargeRadius& large = large_body,
                   Domain domain = Domain::positive);
/// Half of the diameter.
double read_diameter(Source& source, const Field& field, const LargeRadius& large = large_body,
                     Domain domain = Domain::positive);

/// Rejects a table that has both.
void expect_one_size(const Source& source, const Field& table);

/// If either is there.
std::optional<double> find_radius(Source& source, const Field& table, const LargeRadius& large = large_body,
                                  Domain domain = Domain::positive);

}  // namespace mariotte::scene
