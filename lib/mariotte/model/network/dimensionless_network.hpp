// A network in units of order one, as DimensionlessChain is for a chain.
#pragma once
#include <vector>

#include "mariotte/model/contacts/scaled_contacts.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::model {

/// The network divided by `scale`. Velocities of other kinds than lengths per time have units of their own;
/// gap rates are what the reference speed is taken from.
struct DimensionlessNetwork : ScaledContacts {
  Index dofs = 0;
  std::vector<ContactDirection> direction;      ///< G
  std::vector<ContactDirection> response;       ///< columns of M⁻¹ Gᵀ
  std::vector<ContactDirection> half_response;  ///< columns of L⁻¹ Gᵀ, M = L Lᵀ
  std::vector<std::vector<Index>> moved_by;     ///< by dof: contacts that have a term in it
  std::vector<std::vector<Index>> near;         ///< contacts that the push of each one moves
};

/// Of a validated network: gap rates, 0 if nothing moves it.
Speeds speeds(const Network& network);
inline double reference_speed(const Network& network) {
  return speeds(network).reference;
}

/// Of a validated network into `d`, whose memory is reused. `accuracy` decides what is slow: a tenth of what
/// may be wrong anyway. Throws Unrepresentable.
void make_dimensionless(const Network& network, double accuracy, DimensionlessNetwork& d);

/// A network with other numbers than the one `d` was made from, in the units of `d`.
void restate(const Network& network, DimensionlessNetwork& d);

}  // namespace mariotte::model
