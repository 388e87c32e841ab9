#include "mariotte/report/figure/curve_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "mariotte/core/overload.hpp"
#include "mariotte/report/figure/axis_names.hpp"
#include "mariotte/report/table/network_table.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t most_named = 1000;
constexpr std::array axis_letter = {"x", "y", "z"};

CurveNames names(const model::Chain& chain) {
  CurveNames names;
  if (chain.mass.size() > most_named) return names;
  for (std::size_t i = 0; i < chain.mass.size(); ++i)
    names.velocities.push_back(std::isinf(chain.mass[i]) ? "wall" : fmt::format("ball {}", i + 1));
  return names;
}

CurveNames names(const model::Network& network) {
  CurveNames names;
  names.dimension = std::max<Index>(1, network.dimension);
  if (network.dimension == 0 || network.velocity.size() > most_named) return names;
  for (Index i = 0; i < std::ssize(network.velocity); ++i)
    names.velocities.push_back(fmt::format("ball {} {}", i / network.dimension + 1,
                                           axis_letter[static_cast<std::size_t>(i % network.dimension)]));
  const auto pairs = contact_names(network);
  for (std::size_t j = 0; j < pairs.size(); ++j)
    names.contacts.push_back(fmt::format("f_{{{}}} ({})", j + 1, pairs[j]));
  return names;
}

CurveNames names(const model::Bodies& bodies) {
  CurveNames names;
  names.dimension = bodies.dimension;
  if (bodies.body.size() > most_named) return names;
  for (Index i = 0; i < std::ssize(bodies.body); ++i)
    for (int k = 0; k < bodies.dimension; ++k)
      names.velocities.push_back(
          fmt::format("{} {}", plain(body_name(bodies, i)), axis_letter[static_cast<std::size_t>(k)]));
  for (Index i = 0; i < std::ssize(bodies.body); ++i) names.bodies.push_back(plain(body_name(bodies, i)));
  for (const auto& contact : bodies.contact)
    names.contacts.push_back(fmt::format("{}–{}", name_of(bodies, contact.a), name_of(bodies, contact.b)));
  return names;
}

}  // namespace

CurveNames curve_names(const scene::Scene& scene) {
  return std::visit(Overload{[](const model::Chain& chain) { return names(chain); },
                             [](const model::Network& network) { return names(network); },
                             [](const model::Microbody&) { return CurveNames{}; },
                             [](const model::Bodies& bodies) { return names(bodies); },
                             [](const scene::LawAlone&) { return CurveNames{}; }},
                    scene.model);
}

}  // namespace mariotte::report
