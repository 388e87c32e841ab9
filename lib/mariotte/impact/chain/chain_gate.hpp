// What must hold at the end of a run of a chain, whichever flow followed it.
#pragma once
#include "mariotte/impact/energy.hpp"
#include "mariotte/impact/gate.hpp"

namespace mariotte::impact {

/// A chain at the end of a run, dimensionless.
struct ChainOutcome {
  const model::DimensionlessChain& chain;
  const model::ChainLayout& layout;
  const contact::ContactSet& mode;             ///< at the end
  Interval interval;                           ///< the whole run
  const std::vector<double>& impulses;         ///< p_j from momentum
  const std::vector<Index>& periods;           ///< how often each contact closed
  const std::vector<ContactEnergy>& energies;  ///< of each contact
};

/// Nothing approaches after separation, nor what has let go while indented; energy and momentum balance, no
/// contact has pulled, none gave an impulse without having closed, none has gained energy, none is indented
/// without force. `accuracy` is that of the run.
void pass_gate(const ChainOutcome& outcome, double accuracy, hybrid::Ending& ending, std::string& message);

}  // namespace mariotte::impact
