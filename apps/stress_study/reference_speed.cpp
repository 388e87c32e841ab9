#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace mariotte::stress_study {
namespace {

/// 1/m* of two balls that may be walls.
double mobility(const model::Chain& chain, std::size_t j) {
  return 1 / chain.mass[j] + 1 / chain.mass[j + 1];
}

/// Twice the energy of a start indentation per reduced mass.
double stored(const contact::Law& law, double gap, double inverse_mass) {
  return gap < 0 ? 2 * contact::stored_energy(law, -gap) * inverse_mass : 0;
}

/// Gained over the indentation of a ball that lies still.
double static_speed(const model::Chain& chain) {
  const double g = std::abs(chain.gravity);
  double depth = 0;
  for (std::size_t j = 0; j < chain.law.size(); ++j)
    if (const double inverse = mobility(chain, j); inverse > 0)
      depth = std::max(depth, std::pow(g / inverse / contact::stiffness(chain.law[j]),
                                       1 / contact::exponent(chain.law[j])));
  return std::sqrt(2 * g * depth);
}

double speed_of(const model::Chain& chain) {
  const auto [slowest, fastest] = std::minmax_element(chain.velocity.begin(), chain.velocity.end());
  const double spread = std::min(*fastest - *slowest, std::max(std::abs(*slowest), std::abs(*fastest)));
  double squared = spread * spread;
  for (std::size_t j = 0; j < chain.gap.size(); ++j)
    squared += 2 * std::abs(chain.gravity) * std::max(0.0, chain.gap[j]) +
               stored(chain.law[j], chain.gap[j], mobility(chain, j));
  if (squared > 0) return std::sqrt(squared);
  return chain.gravity == 0 ? 1 : static_speed(chain);
}

/// The largest incident speed of a contact; of start indentations what they give back.
double speed_of(const model::Network& network) {
  const auto response = model::responses(network.mass, network.direction, std::ssize(network.velocity));
  double fastest = 0, squared = 0;
  for (std::size_t j = 0; j < network.law.size(); ++j) {
    fastest = std::max(fastest, std::abs(gap_rate(network.direction[j], network.velocity)));
    squared += stored(network.law[j], network.gap[j], dot(network.direction[j], response[j]));
  }
  const double speed = std::sqrt(fastest * fastest + squared);
  return speed > 0 ? speed : 1;
}

double speed_of(const Body& scene) {
  const auto& body = scene.body;
  const Vector3 turning = cross(body.spin, rotate(body.attitude, body.body.tips[0].centre));
  return std::max(norm(body.velocity), norm(body.velocity + turning));
}

/// Of surfaces, and what gravity adds on the way to the first contact.
double speed_of(const Group& scene) {
  double fastest = 0, height = 0;
  for (const auto& body : scene.bodies.body)
    for (const auto& sphere : body.spheres)
      fastest =
          std::max(fastest, norm(body.velocity) + norm(body.spin) * (norm(sphere.centre) + sphere.radius));
  for (const auto& contact : scene.bodies.contact)
    height = std::max(height, model::start_gap(scene.bodies, contact));
  return std::sqrt(fastest * fastest + 2 * norm(scene.bodies.gravity) * height);
}

}  // namespace

double reference_speed(const Model& model) {
  return std::visit([](const auto& one) { return speed_of(one); }, model);
}

}  // namespace mariotte::stress_study
