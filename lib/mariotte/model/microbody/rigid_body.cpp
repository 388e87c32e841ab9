#include "mariotte/model/microbody/rigid_body.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::model {
namespace {

/// A cylinder of this mass between two hemispheres of the material's density.
RigidBody capped(double cylinder, double radius, double length, double density) {
  const double caps = 4.0 / 3.0 * std::numbers::pi * density * radius * radius * radius;
  const double square = radius * radius, reach = length / 2 + 3 * radius / 8;
  const double axial = cylinder * square / 2 + 0.4 * caps * square;
  const double transverse =
      cylinder * (square / 4 + length * length / 12) + caps * (83.0 / 320.0 * square + reach * reach);
  return {.mass = cylinder + caps,
          .inertia = {axial, transverse, transverse},
          .tips = {{.centre = {-length / 2, 0, 0}, .radius = radius},
                   {.centre = {length / 2, 0, 0}, .radius = radius}}};
}

bool is_positive(double value) {
  return value > 0 && std::isfinite(value);
}

}  // namespace

RigidBody sphere(double radius, double density) {
  const double mass = 4.0 / 3.0 * std::numbers::pi * density * radius * radius * radius;
  const double inertia = 0.4 * mass * radius * radius;
  return {.mass = mass,
          .inertia = {inertia, inertia, inertia},
          .tips = {{.centre = {0, 0, 0}, .radius = radius}}};
}

RigidBody dumbbell(double radius, double length_ratio, double density) {
  if (length_ratio == 0) return sphere(radius, density);
  return capped(0, radius, length_ratio * radius, density);
}

RigidBody rod(double radius, double length_ratio, double density) {
  if (length_ratio == 0) return sphere(radius, density);
  const double length = length_ratio * radius;
  return capped(std::numbers::pi * radius * radius * length * density, radius, length, density);
}

double reach(const RigidBody& body) {
  double most = 0;
  for (const auto& tip : body.tips) most = std::max(most, norm(tip.centre) + tip.radius);
  return most;
}

bool is_symmetric(const RigidBody& body) {
  for (const auto& tip : body.tips)
    if (tip.centre.e2 != 0 || tip.centre.e3 != 0) return false;
  return body.inertia.e2 == body.inertia.e3;
}

void validate(const RigidBody& body) {
  if (!is_positive(body.mass)) throw InvalidParameter("mass must be positive and finite");
  const auto& [a, b, c] = body.inertia;
  if (!is_positive(a) || !is_positive(b) || !is_positive(c))
    throw InvalidParameter("moments of inertia must be positive and finite");
  const double slack = 1 + 8 * epsilon;  // of bodies as thin as a disc, which reach the limit
  if (a > slack * (b + c) || b > slack * (a + c) || c > slack * (a + b))
    throw InvalidParameter("no body has such moments of inertia: one is larger than the sum of the others");
  if (body.tips.empty() || body.tips.size() > 2) throw InvalidParameter("a body has one or two tips");
  for (std::size_t i = 0; i < body.tips.size(); ++i) {
    const auto name = "tip " + std::to_string(i + 1);
    if (!is_positive(body.tips[i].radius)) throw InvalidParameter(name + ": radius must be positive");
    if (!std::isfinite(norm(body.tips[i].centre))) throw InvalidParameter(name + ": centre must be finite");
  }
}

}  // namespace mariotte::model
