#include "mariotte/impact/shallow.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::impact {
namespace {

/// ½ vᵀ M v [J]; infinite if a wall moves.
double kinetic(const model::MassMatrix& mass, const std::vector<double>& velocity) {
  const auto n = std::ssize(velocity);
  double twice = 0;
  for (Index i = 0; i < n; ++i) {
    if (velocity[i] == 0) continue;
    if (model::is_diagonal(mass, n))
      twice += mass[i] * velocity[i] * velocity[i];
    else
      for (Index j = 0; j < n; ++j) twice += mass[i * n + j] * velocity[i] * velocity[j];
  }
  return 0.5 * twice;
}

/// Of a chain or network: whether `energy` [J] and what is stored at the start are too little for every
/// contact.
template <class Model>
bool suffices_nowhere(const Model& model, double energy, std::span<const Touching> touching) {
  for (std::size_t j = 0; j < model.law.size(); ++j) {
    if (!contact::power_law(model.law[j])) return false;
    if (model.gap[j] < 0) energy += contact::stored_energy(model.law[j], -model.gap[j]);
  }
  for (std::size_t j = 0; j < touching.size(); ++j)
    if (touching[j].radius > 0 &&
        !(contact::stored_energy(model.law[j], touching[j].smaller_radius) >= energy))
      return false;
  return true;
}

/// ½ m v² and at most ½ I ω² [J].
double largest_kinetic(const model::Microbody& body) {
  const auto& [mass, inertia, tips] = body.body;
  return 0.5 * (mass * dot(body.velocity, body.velocity) +
                std::max({inertia.e1, inertia.e2, inertia.e3}) * dot(body.spin, body.spin));
}

}  // namespace

bool stays_shallow(const model::Chain& chain, std::span<const Touching> touching) {
  if (touching.empty()) return true;
  return chain.gravity == 0 && suffices_nowhere(chain, kinetic(chain.mass, chain.velocity), touching);
}

bool stays_shallow(const model::Network& network, std::span<const Touching> touching) {
  return touching.empty() || suffices_nowhere(network, kinetic(network.mass, network.velocity), touching);
}

/// The wells of the other tips may give their energy to one.
bool stays_shallow(const model::Microbody& body, std::span<const Touching> touching) {
  if (touching.empty()) return true;
  if (body.gravity != 0) return false;
  double energy = largest_kinetic(body);
  for (const auto& law : body.law) energy -= contact::stored_energy(law, contact::rest_indentation(law));
  for (std::size_t i = 0; i < touching.size(); ++i)
    if (!(contact::stored_energy(body.law[i], touching[i].smaller_radius) >= energy)) return false;
  return true;
}

}  // namespace mariotte::impact
