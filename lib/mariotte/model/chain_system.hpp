// A chain as a hybrid system: which contacts act, and what comes after a guard has fired.
#pragma once
#include <vector>

#include "mariotte/model/chain_phase.hpp"

namespace mariotte::model {

/// A contact that passes from one mode to another.
struct ContactChange {
  Index contact;
  contact::ContactMode before;
  contact::ContactMode after;
};

/// Satisfies hybrid::HybridSystem. Dimensionless; `chain.scale` leads back.
class ChainSystem {
 public:
  using Mode = contact::ContactSet;
  using Change = ContactChange;

  /// `stay` keeps a chain that gravity leads back to a wall going after its first impact.
  ChainSystem(const Chain& chain, double accuracy, bool stay);

  std::vector<double> start() const { return initial_state(chain, layout); }

  /// Contacts that carry force at 0+: indented ones, touching ones that approach or are driven together, and
  /// touching ones at rest that stand in a row with one of these.
  Mode mode_at(ConstState x, std::vector<Change>& changes) const;
  /// What has fired, and closed contacts that have faded by then.
  void transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                  std::vector<Change>& changes) const;
  /// No contact carries force and the velocities are in order from left to right: a theorem without outside
  /// forces. Where gravity leads back to a wall, the end of the first impact.
  bool is_over(const Mode& mode, ConstState x, bool impacted) const;
  /// Contacts that touched but were never pressed noticeably open at the end.
  void finish(Mode& mode, std::vector<Change>& changes) const;
  ChainPhase& problem(Mode& mode);
  const ChainPhase& phase() const { return phase_; }

  const DimensionlessChain chain;
  const ChainLayout layout;

 private:
  double approach(ConstState x, Index j) const;
  contact::ContactMode after(contact::ContactMode mode, bool load_fired, double gap, double approach) const;
  bool rests(const Mode& mode, ConstState x, Index j) const;
  void press_row(Mode& mode, ConstState x, Index from, std::vector<Change>& changes) const;

  ChainGuards guards_;
  ChainPhase phase_;
  bool stay_;
};

}  // namespace mariotte::model
