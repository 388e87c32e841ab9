#include "mariotte/scene/radius.hpp"

#include <cmath>

namespace mariotte::scene {
namespace {

double judged(Source& source, const Field& field, double radius, const LargeRadius& large) {
  if (std::isfinite(radius) && radius > large.most) warn(source, field, large.warning);
  return radius;
}

}  // namespace

double read_radius(Source& source, const Field& field, const LargeRadius& large, Domain domain) {
  return judged(source, field, number(source, field, dimension::length, domain), large);
}

double read_diameter(Source& source, const Field& field, const LargeRadius& large, Domain domain) {
  return judged(source, field, 0.5 * number(source, field, dimension::length, domain), large);
}

void expect_one_size(const Source& source, const Field& table) {
  if (const auto diameter = find(table, "diameter"); diameter && find(table, "radius"))
    reject(source, *diameter, fault::contradiction, "'radius' is given, too; give one of them");
}

std::optional<double> find_radius(Source& source, const Field& table, const LargeRadius& large,
                                  Domain domain) {
  expect_one_size(source, table);
  if (const auto radius = find(table, "radius")) return read_radius(source, *radius, large, domain);
  if (const auto diameter = find(table, "diameter")) return read_diameter(source, *diameter, large, domain);
  return {};
}

}  // namespace mariotte::scene
