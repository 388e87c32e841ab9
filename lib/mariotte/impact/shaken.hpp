// Models with masses and gaps that are moved by rounding errors: what becomes of that is what rounding does
// to a run.
#pragma once
#include <array>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/model/bodies/bodies.hpp"
#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/microbody/microbody.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::impact {

/// Ways to go up and down, bit i for number i: how much one of them tells is a matter of luck.
inline constexpr std::array shakes = {0xAAAAAAAAu, 0x9C3F5A16u, 0x6B1D93E4u};

/// Number i, changed by more than the rounding of one operation.
inline double shaken(double number, std::size_t i, unsigned shake) {
  return number * (1 + (shake >> i % 32 & 1 ? 4 : -4) * epsilon);
}

/// One number after the other, from bit `first` on.
inline void shake_all(std::vector<double>& numbers, std::size_t first, unsigned shake) {
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = shaken(numbers[i], first + i, shake);
}

/// Stiffnesses, but beside a damper: contacts of one ratio c/k keep it.
inline void shake_all(std::vector<contact::Law>& laws, std::size_t first, unsigned shake) {
  for (std::size_t j = 0; j < laws.size(); ++j)
    if (auto* const law = std::get_if<contact::PowerLaw>(&laws[j]); law && law->damping == 0)
      law->stiffness = shaken(law->stiffness, first + j, shake);
}

inline model::Chain shaken(model::Chain chain, unsigned shake) {
  shake_all(chain.mass, 0, shake);
  shake_all(chain.gap, chain.mass.size(), shake);
  shake_all(chain.law, chain.mass.size() / 2, shake);
  return chain;
}

/// A full mass matrix is shaken along its diagonal, so that it stays symmetric.
inline model::Network shaken(model::Network network, unsigned shake) {
  const std::size_t dofs = network.velocity.size(), step = network.mass.size() == dofs ? 1 : dofs + 1;
  for (std::size_t i = 0; i < dofs; ++i) network.mass[step * i] = shaken(network.mass[step * i], i, shake);
  shake_all(network.gap, dofs, shake);
  shake_all(network.law, dofs / 2, shake);
  return network;
}

/// Principal moments; equal ones alike, so that a symmetric body stays one.
inline Vector3 shaken(const Vector3& moment, std::size_t first, unsigned shake) {
  const auto& [e1, e2, e3] = moment;
  return {shaken(e1, e1 == e2 ? first + 1 : first, shake), shaken(e2, first + 1, shake),
          shaken(e3, e3 == e2 ? first + 1 : first + 2, shake)};
}

inline model::Bodies shaken(model::Bodies bodies, unsigned shake) {
  for (std::size_t i = 0; i < bodies.body.size(); ++i) {
    auto& body = bodies.body[i];
    body.mass = shaken(body.mass, i, shake);
    body.inertia = shaken(body.inertia, bodies.body.size() + 3 * i, shake);
  }
  return bodies;
}

/// One body has few numbers: how it moves is shaken as well.
inline model::Microbody shaken(model::Microbody body, unsigned shake) {
  body.body.mass = shaken(body.body.mass, 0, shake);
  body.body.inertia = shaken(body.body.inertia, 1, shake);
  body.velocity = shaken(1.0, 4, shake) * body.velocity;
  body.spin = shaken(1.0, 5, shake) * body.spin;
  body.gravity = shaken(body.gravity, 6, shake);
  return body;
}

}  // namespace mariotte::impact
