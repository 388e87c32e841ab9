#include "mariotte/model/network/network_layout.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::model {

NetworkLayout make_layout(const DimensionlessNetwork& network) {
  NetworkLayout layout;
  layout.freedoms = network.freedoms;
  layout.contacts = network.contacts();
  layout.size = layout.freedoms + 2 * layout.contacts;
  for (Index j = 0; j < layout.contacts; ++j) layout.guard_contact.push_back(j);
  for (Index j = 0; j < layout.contacts; ++j) {
    const bool damped = contact::dissipates(network.law[j]);
    layout.work.push_back(damped ? layout.size++ : NetworkLayout::absent);
    layout.load_guard.push_back(damped ? std::ssize(layout.guard_contact) : NetworkLayout::absent);
    if (damped) layout.guard_contact.push_back(j);
  }
  return layout;
}

std::vector<double> initial_state(const DimensionlessNetwork& network, const NetworkLayout& layout) {
  auto x = network.velocity;
  x.resize(layout.size, 0.0);
  for (Index j = 0; j < layout.contacts; ++j) {
    x[layout.gap(j)] = network.gap[j];
    if (layout.work[j] != NetworkLayout::absent && network.gap[j] < 0)
      x[layout.work[j]] = contact::stored_energy(network.law[j], -network.gap[j]);
  }
  return x;
}

std::vector<double> magnitudes(const DimensionlessNetwork& d, const NetworkLayout& at) {
  std::vector<double> size(at.size, 0.0);
  for (Index j = 0; j < at.contacts; ++j) {
    const double momentum = d.reduced_mass[j] * d.speed;
    size[at.gap(j)] = d.length[j];
    size[at.impulse(j)] = momentum;
    if (at.work[j] != NetworkLayout::absent) size[at.work[j]] = momentum * d.speed;
    // A heavy body changes its velocity little: what this contact can do to it.
    for (const auto& [freedom, change] : d.push[j])
      size[freedom] = std::max(size[freedom], std::min(d.speed, 2 * momentum * std::abs(change)));
  }
  for (Index i = 0; i < at.freedoms; ++i)
    if (size[i] == 0) size[i] = d.speed;
  return size;
}

std::string component_name(const NetworkLayout& layout, Index index) {
  const Index n = layout.freedoms, m = layout.contacts;
  if (index < n) return "velocity " + std::to_string(index + 1);
  if (index < n + m) return "gap " + std::to_string(index - n + 1);
  if (index < n + 2 * m) return "impulse " + std::to_string(index - n - m + 1);
  const auto place = std::find(layout.work.begin(), layout.work.end(), index);
  return "work " + std::to_string(place - layout.work.begin() + 1);
}

}  // namespace mariotte::model
