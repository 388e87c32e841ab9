// Where each quantity of a chain stands in the state vector.
#pragma once
#include <string>
#include <vector>

#include "mariotte/flow/problem.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"

namespace mariotte::model {

/// The state runs along the chain, v_1 g_1 v_2 g_2 … v_n, so that the Jacobian is a narrow band. Two kinds of
/// integrals stand behind the gap of those contacts that need them:
///   work     W = ∫ f δ̇ dt [energy], of damped contacts: the energy given to the contact, stored or lost;
///   impulse  P = ∫ f dt, of contacts with a wall, where momentum alone does not tell it.
struct ChainLayout {
  static constexpr Index absent = -1;
  Index size = 0;
  std::vector<Index> velocity;  ///< n places
  std::vector<Index> gap;       ///< n−1 places
  std::vector<Index> work;      ///< n−1 places or absent
  std::vector<Index> impulse;   ///< n−1 places or absent

  Index balls() const { return static_cast<Index>(velocity.size()); }
  Index contacts() const { return static_cast<Index>(gap.size()); }
};

/// Fills what it is given and reuses its memory.
void make_layout(const DimensionlessChain& chain, ChainLayout& layout);

/// State at the start; the work of a contact that starts indented is its stored energy.
void initial_state(const DimensionlessChain& chain, const ChainLayout& layout, std::vector<double>& x);

/// Natural size of each component of the state.
void magnitudes(const DimensionlessChain& chain, const ChainLayout& layout, std::vector<double>& size);

/// "velocity 3", "gap 2", … for messages; counted from 1.
std::string component_name(const ChainLayout& layout, Index component);

}  // namespace mariotte::model
