#include "mariotte/scene/material.hpp"

#include <array>
#include <cmath>
#include <vector>

#include "mariotte/scene/material_library.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 4> material_keys{"young", "poisson", "density", "yield_strength"};

void warn_of_slips(Source& source, const Field& field, const Material& material) {
  // No solid that dense is that soft: rubber and foams stay below 2000 kg/m³, metal and stone above 1 GPa.
  if (material.young && material.density && *material.young < 1e9 && *material.density >= 2000)
    warn(source, *find(field, "young"), "below 1 GPa is very soft for this density (GPa meant?)");
  if (material.young && std::isfinite(*material.young) && *material.young > 2e12)
    warn(source, *find(field, "young"), "stiffer than diamond (inf makes a body rigid)");
}

double read_poisson(const Source& source, const Field& field) {
  const double poisson = number(source, field, dimension::none, Domain::finite);
  if (!(poisson > -1 && poisson <= 0.5))
    reject(source, field, fault::out_of_range, "must be above -1 and at most 0.5");
  return poisson;
}

Material named_material(const Source& source, const Field& field) {
  static const auto names = [] {
    std::vector<std::string_view> list;
    for (const auto& one : named_materials()) list.push_back(one.name);
    return list;
  }();
  const auto& found = named_materials()[choice(source, field, "material", names)];
  Material material;
  material.young = found.young.value;
  material.poisson = found.poisson.value;
  material.density = found.density.value;
  if (found.yield_strength) material.yield_strength = found.yield_strength->value;
  return material;
}

}  // namespace

double read_density(Source& source, const Field& field) {
  const double density = number(source, field, dimension::density, Domain::positive);
  if (density < 50 || density > 25000) warn(source, field, "outside 50 to 25000 kg/m^3 (is the unit right?)");
  return density;
}

Material read_material(Source& source, const Field& field) {
  if (std::holds_alternative<std::string>(field.node->value)) return named_material(source, field);
  expect_keys(source, field, material_keys);
  Material material;
  if (const auto young = find(field, "young"))
    material.young = number(source, *young, dimension::pressure, Domain::positive_or_infinite);
  if (const auto poisson = find(field, "poisson")) material.poisson = read_poisson(source, *poisson);
  if (const auto density = find(field, "density")) material.density = read_density(source, *density);
  if (const auto yield = find(field, "yield_strength"))
    material.yield_strength = number(source, *yield, dimension::pressure, Domain::positive);
  if (material.young && std::isinf(*material.young) && !material.poisson) material.poisson = 0;
  warn_of_slips(source, field, material);
  return material;
}

std::optional<contact::Elasticity> elastic(const Material& material) {
  if (!material.young || !material.poisson) return {};
  return contact::Elasticity{.young = *material.young, .poisson = *material.poisson};
}

}  // namespace mariotte::scene
