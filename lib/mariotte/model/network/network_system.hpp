// A network as a hybrid system: which contacts act, and what comes after a guard has fired.
#pragma once
#include "mariotte/hybrid/ending.hpp"
#include "mariotte/model/network/network_phase.hpp"

namespace mariotte::model {

/// Satisfies hybrid::HybridSystem, with the automaton of the chain. A contact that touches at rest is pressed
/// or parted at once when a contact near it is pressed: it turns touching, and open if it is pulled apart.
class NetworkSystem {
 public:
  using Mode = contact::ContactSet;
  using Change = ContactChange;

  NetworkSystem(const Network& network, double accuracy);
  NetworkSystem(const NetworkSystem&) = delete;
  NetworkSystem& operator=(const NetworkSystem&) = delete;
  const DimensionlessNetwork& network() const { return network_; }
  const NetworkLayout& layout() const { return layout_; }
  const NetworkPhase& phase() const { return phase_; }

  void mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const;
  void transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                  std::vector<Change>& changes) const;
  bool is_over(const Mode& mode, ConstState x, bool impacted) const;
  hybrid::Ending ending(const Mode&) const { return hybrid::Ending::separated; }
  void finish(Mode& mode, std::vector<Change>& changes) const;
  NetworkPhase& problem(Mode& mode);

 private:
  bool rests(const Mode& mode, ConstState x, Index j) const;
  void press_near(Mode& mode, ConstState x, Index from, std::vector<Change>& changes) const;

  DimensionlessNetwork network_;
  NetworkLayout layout_;
  NetworkPhase phase_;
};

}  // namespace mariotte::model
