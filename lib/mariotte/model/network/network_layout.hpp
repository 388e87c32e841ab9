// Where each quantity of a network stands in the state vector.
#pragma once
#include <string>
#include <vector>

#include "mariotte/model/network/dimensionless_network.hpp"

namespace mariotte::model {

/// The state is v (n), g (m), P = ∫ f dt (m), and W = ∫ f δ̇ dt of the damped contacts. Impulses are
/// integrated since momentum does not tell them where contacts are redundant. Guards 0 … m−1 are the gaps,
/// those behind are the loads of damped contacts.
struct NetworkLayout {
  static constexpr Index absent = -1;
  Index freedoms = 0, contacts = 0, size = 0;
  std::vector<Index> work;           ///< by contact: its place, or absent
  std::vector<Index> load_guard;     ///< by contact: guard of its load, or absent
  std::vector<Index> guard_contact;  ///< by guard

  Index gap(Index j) const { return freedoms + j; }
  Index impulse(Index j) const { return freedoms + contacts + j; }
};

/// Of a network's state.
NetworkLayout make_layout(const DimensionlessNetwork& network);

/// State at the start; the work of a contact that starts indented is its stored energy.
std::vector<double> initial_state(const DimensionlessNetwork& network, const NetworkLayout& layout);

/// Natural size of each component of the state.
std::vector<double> magnitudes(const DimensionlessNetwork& network, const NetworkLayout& layout);

/// "velocity 3", "gap 2", … for messages; counted from 1.
std::string component_name(const NetworkLayout& layout, Index component);

}  // namespace mariotte::model
