// A network in units of order one, as DimensionlessChain is for a chain.
#pragma once
#include <vector>

#include "mariotte/core/scale.hpp"
#include "mariotte/model/network/network.hpp"

namespace mariotte::model {

/// A network in units in which its numbers are of order one.
struct DimensionlessNetwork {
  Scale scale;
  Index freedoms = 0;
  std::vector<ContactDirection> direction;  ///< G
  std::vector<ContactDirection> push;       ///< columns of M⁻¹ Gᵀ
  std::vector<ContactDirection> half_push;  ///< columns of L⁻¹ Gᵀ, M = L Lᵀ
  std::vector<contact::Law> law;
  std::vector<double> gap, velocity;
  double speed = 1;                      ///< largest gap rate at the start, and what stored energy can add
  std::vector<double> reduced_mass;      ///< 1/(G M⁻¹ Gᵀ)_jj
  std::vector<double> length, time;      ///< natural ones of each contact alone
  double slow = 0;                       ///< approach that cannot be told from rest
  std::vector<double> shallow;           ///< depth that a contact approached so slowly reaches
  std::vector<std::vector<Index>> near;  ///< contacts that the push of each one moves

  Index contacts() const { return std::ssize(law); }
};

/// Of a validated network. `accuracy` decides what is slow: a tenth of what may be wrong anyway. Throws
/// Unrepresentable.
DimensionlessNetwork make_dimensionless(const Network& network, double accuracy);

}  // namespace mariotte::model
