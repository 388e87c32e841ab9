// A chain as a hybrid system: which contacts act, and what comes after a guard has fired.
#pragma once
#include <vector>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/model/chain/chain_modes.hpp"
#include "mariotte/model/chain/chain_phase.hpp"

namespace mariotte::model {

/// Satisfies hybrid::HybridSystem. Dimensionless; `chain().scale` leads back.
class ChainSystem {
 public:
  using Mode = contact::ContactSet;
  using Change = ContactChange;

  ChainSystem() : phase_(chain_, layout_) {}
  ChainSystem(const ChainSystem&) = delete;
  ChainSystem& operator=(const ChainSystem&) = delete;

  /// Become the system of another chain and reuse the memory. `stay` keeps a chain that gravity leads back to
  /// a wall going after its first impact.
  void reset(const Chain& chain, double accuracy, bool stay);
  /// Become the system of balls `first` to `last` of a chain; its phases end where a row of touching contacts
  /// is about to push beyond them, `margin` contacts before it does.
  void reset(const DimensionlessChain& whole, Index first, Index last, Index margin);
  const DimensionlessChain& chain() const { return chain_; }
  const ChainLayout& layout() const { return layout_; }

  /// Contacts that carry force at 0+: indented ones, touching ones that approach or are driven together, and
  /// touching ones at rest that stand in a row with one of these.
  void mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const;
  /// What has fired, closed contacts that have faded by then, and touching ones that have left the noise.
  void transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                  std::vector<Change>& changes) const;
  /// No contact carries force and the velocities are in order from left to right: a theorem without outside
  /// forces. Where gravity leads back to a wall, the end of the first impact.
  bool is_over(const Mode& mode, ConstState x, bool impacted) const;
  hybrid::Ending ending(const Mode&) const { return hybrid::Ending::separated; }
  /// Contacts that touched but were never pressed noticeably open at the end.
  void finish(Mode& mode, std::vector<Change>& changes) const;
  ChainPhase& problem(Mode& mode);
  const ChainPhase& phase() const { return phase_; }

 private:
  ChainState state(ConstState x) const { return {chain_, layout_, x}; }

  DimensionlessChain chain_;
  ChainLayout layout_;
  ChainGuards guards_;
  ChainPhase phase_;
  bool stay_ = false;
};

}  // namespace mariotte::model
