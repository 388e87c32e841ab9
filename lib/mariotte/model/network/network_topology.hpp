// A network as contacts that join velocities in any way.
#pragma once
#include <optional>

#include "mariotte/flow/linked_phase.hpp"
#include "mariotte/flow/serial_phase.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"
#include "mariotte/model/network/dimensionless_network.hpp"

namespace mariotte::model {

struct NetworkTopology;

/// A network as the flows see it that need more than a field: as the row that its contacts are in, −1 and +1
/// in two velocities each, or as linked velocities.
class NetworkFlows {
 public:
  void reset(const NetworkTopology& network);
  /// A network is never a slice of another.
  bool is_at_edge(Index) const { return false; }

  flow::PhaseContact& contact(Index j) {
    return row_.empty() ? linked_.contact[j] : serial_.contact[row_[j]];
  }
  const flow::PhaseContact& contact(Index j) const {
    return row_.empty() ? linked_.contact[j] : serial_.contact[row_[j]];
  }
  const flow::SerialPhase* serial() const { return row_.empty() ? nullptr : &serial_; }
  const flow::LinkedPhase* linked() const { return row_.empty() ? &linked_ : nullptr; }

 private:
  /// The dofs that a contact of a row joins.
  struct Ends {
    Index left, right;
  };
  static std::optional<Ends> ends_of(const DimensionlessNetwork& network, Index j);
  bool drives_within(const DimensionlessNetwork& network) const;
  void find_row(const DimensionlessNetwork& network);
  bool find_ends(const DimensionlessNetwork& network);
  void make_serial(const NetworkTopology& topology);
  void make_linked(const NetworkTopology& topology);
  void couple(const NetworkTopology& topology, Index j);

  std::vector<Ends> ends_;                ///< by contact
  std::vector<Index> starting_, ending_;  ///< by dof: the contact that has it on its left, right
  std::vector<Index> row_;                ///< by contact: its place in the row; empty if the network is none
  flow::SerialPhase serial_;              ///< unless it is none
  flow::LinkedPhase linked_;              ///< if it is none
};

/// Contact j has the direction G_j. No outside force acts.
struct NetworkTopology {
  using Model = DimensionlessNetwork;
  using Flows = NetworkFlows;

  const DimensionlessNetwork& model;
  const ContactLayout& at;

  /// Gap rates are sums of products of velocities: equal velocities leave rounding.
  double rest_speed() const { return 8 * epsilon * model.speed; }
  double approach(ConstState x, Index j) const { return -gap_rate(model.direction[j], x); }
  double drive(Index) const { return 0; }
  double acceleration(Index) const { return 0; }
  double coupling(Index j, Index i) const { return dot(model.direction[j], model.response[i]); }

  template <class Use>
  void for_each_near(Index j, Use&& use) const {
    for (const Index near : model.near[j]) use(near);
  }
  template <class Use>
  void for_each_direction(Index j, Use&& use) const {
    for (const auto& [dof, coefficient] : model.direction[j]) use(dof, coefficient);
  }
  template <class Use>
  void for_each_push(Index j, Use&& use) const {
    for (const auto& [dof, change] : model.response[j]) use(dof, change);
  }
};

}  // namespace mariotte::model
