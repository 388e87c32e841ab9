// What must hold at the end of a run of a network, whichever flow followed it.
#pragma once
#include "mariotte/impact/energy.hpp"
#include "mariotte/impact/gate.hpp"
#include "mariotte/model/network/dimensionless_network.hpp"

namespace mariotte::impact {

/// A network at the end of a run, dimensionless.
struct NetworkOutcome {
  const model::DimensionlessNetwork& network;
  const model::ContactLayout& layout;
  const contact::ContactSet& mode;  ///< at the end
  Interval interval;                ///< the whole run
};

/// The gate of networks, and its memory.
class NetworkGate {
 public:
  /// Nothing approaches after separation, energy and momentum balance, no contact has pulled, none has gained
  /// energy, none is indented without force. `accuracy` is that of the run. Allocates nothing after the first
  /// network of a size if all hold.
  void pass(const NetworkOutcome& outcome, double accuracy, hybrid::Ending& ending, std::string& message);

 private:
  /// The largest part of a velocity's change that impulses do not explain, in units of what is natural.
  double unexplained(const NetworkOutcome& outcome);

  std::vector<ContactEnergy> energies_;
  std::vector<double> change_, natural_;  ///< of each velocity
};

}  // namespace mariotte::impact
