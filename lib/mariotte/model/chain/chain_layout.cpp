#include "mariotte/model/chain/chain_layout.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::model {

void make_layout(const DimensionlessChain& chain, ChainLayout& layout) {
  layout.size = 0;
  for (auto* places : {&layout.velocity, &layout.gap, &layout.work, &layout.impulse}) places->clear();
  for (std::size_t i = 0; i < chain.mass.size(); ++i) {
    layout.velocity.push_back(layout.size++);
    if (i == chain.law.size()) break;
    const bool wall = std::isinf(chain.mass[i]) || std::isinf(chain.mass[i + 1]);
    layout.gap.push_back(layout.size++);
    layout.work.push_back(contact::dissipates(chain.law[i]) ? layout.size++ : ChainLayout::absent);
    layout.impulse.push_back(wall ? layout.size++ : ChainLayout::absent);
  }
}

void initial_state(const DimensionlessChain& chain, const ChainLayout& layout, std::vector<double>& x) {
  x.assign(layout.size, 0.0);
  for (Index i = 0; i < layout.balls(); ++i) x[layout.velocity[i]] = chain.velocity[i];
  for (Index j = 0; j < layout.contacts(); ++j) {
    x[layout.gap[j]] = chain.gap[j];
    if (layout.work[j] != ChainLayout::absent && chain.gap[j] < 0)
      x[layout.work[j]] = contact::stored_energy(chain.law[j], -chain.gap[j]);
  }
}

void magnitudes(const DimensionlessChain& chain, const ChainLayout& layout, std::vector<double>& size) {
  size.assign(layout.size, 0.0);
  for (Index j = 0; j < layout.contacts(); ++j) {
    const double momentum = chain.reduced_mass[j] * chain.speed;
    size[layout.gap[j]] = chain.length[j];
    if (layout.work[j] != ChainLayout::absent) size[layout.work[j]] = momentum * chain.speed;
    if (layout.impulse[j] != ChainLayout::absent) size[layout.impulse[j]] = momentum;
    // A heavy ball changes its velocity little: what its light neighbour can do to it.
    for (const Index i : {j, j + 1}) {
      auto& velocity = size[layout.velocity[i]];
      velocity =
          std::max(velocity, chain.speed * std::min(1.0, 2 * chain.reduced_mass[j] * chain.inverse_mass[i]));
    }
  }
  for (Index i = 0; i < layout.balls(); ++i)
    if (chain.inverse_mass[i] == 0) size[layout.velocity[i]] = chain.speed;
}

std::string component_name(const ChainLayout& layout, Index component) {
  const auto find = [&](const std::vector<Index>& places, const char* quantity) -> std::string {
    const auto place = std::find(places.begin(), places.end(), component);
    return place == places.end() ? "" : quantity + std::to_string(place - places.begin() + 1);
  };
  for (const auto& name : {find(layout.velocity, "velocity "), find(layout.gap, "gap "),
                           find(layout.work, "work "), find(layout.impulse, "impulse ")})
    if (!name.empty()) return name;
  return "component " + std::to_string(component);
}

}  // namespace mariotte::model
