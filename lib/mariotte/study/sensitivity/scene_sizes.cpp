#include "mariotte/study/sensitivity/scene_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mariotte/core/overload.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::study {
namespace {

/// One of each, in SI, until a number of the scene takes its place.
class Sizes {
 public:
  void add_mass(double one) { take_smaller(one, mass_); }
  void add_length(double one) { take_smaller(one, length_); }
  void add_speed(double one) { speed_ = std::max(speed_, std::abs(one)); }

  double of(const Dimension& dimension) const {
    const double mass = std::isinf(mass_) ? 1 : mass_, length = std::isinf(length_) ? 1 : length_,
                 time = length / (speed_ > 0 ? speed_ : 1);
    return std::pow(mass, dimension.kg) * std::pow(length, dimension.m) * std::pow(time, dimension.s);
  }

 private:
  static void take_smaller(double one, double& size) {
    if (one > 0) size = std::min(size, one);
  }

  double mass_ = infinity, length_ = infinity, speed_ = 0;
};

void add(Sizes& sizes, const std::vector<double>& radii, const std::vector<double>& velocities) {
  for (const double one : radii) sizes.add_length(one);
  for (const double one : velocities) sizes.add_speed(one);
}

Sizes sizes_of(const scene::Scene& scene) {
  Sizes sizes;
  std::visit(Overload{[&](const model::Chain& chain) {
                        for (const double one : chain.mass) sizes.add_mass(one);
                        add(sizes, scene.radius, chain.velocity);
                      },
                      [&](const model::Network& network) { add(sizes, scene.radius, network.velocity); },
                      [&](const model::Microbody& one) {
                        sizes.add_mass(one.body.mass);
                        sizes.add_length(reach(one.body));
                        sizes.add_speed(norm(one.velocity));
                      },
                      [&](const model::Bodies& bodies) {
                        for (const auto& one : bodies.body) {
                          sizes.add_mass(one.mass);
                          for (const auto& sphere : one.spheres) sizes.add_length(sphere.radius);
                          sizes.add_speed(norm(one.velocity));
                        }
                      },
                      [](const scene::LawAlone&) {}},
             scene.model);
  return sizes;
}

}  // namespace

double typical(const scene::Scene& scene, const Dimension& dimension) {
  return sizes_of(scene).of(dimension);
}

}  // namespace mariotte::study
