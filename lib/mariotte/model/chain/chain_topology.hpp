// A chain as contacts that join each ball to the next.
#pragma once
#include <algorithm>

#include "mariotte/flow/linked_phase.hpp"
#include "mariotte/flow/serial_phase.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"
#include "mariotte/model/contacts/contact_layout.hpp"

namespace mariotte::model {

/// Edges of a slice beyond which the chain goes on. A contact nearer than `margin` to such an edge must not
/// push: what it would push on is not there.
struct SliceEdges {
  bool left = false;
  bool right = false;
  Index margin = 0;
};

struct ChainTopology;

/// A chain as the flows see it that need more than a field.
class ChainFlows {
 public:
  void reset(const ChainTopology& chain);
  /// For a slice: phases end where a touching contact at such an edge is loaded.
  void set_edges(SliceEdges edges);
  SliceEdges edges() const { return edges_; }
  bool is_at_edge(Index j) const;

  flow::PhaseContact& contact(Index j) { return serial_.contact[j]; }
  const flow::PhaseContact& contact(Index j) const { return serial_.contact[j]; }
  const flow::SerialPhase* serial() const { return &serial_; }
  const flow::LinkedPhase* linked() const { return nullptr; }

 private:
  flow::SerialPhase serial_;
  SliceEdges edges_;
};

/// Contact j joins balls j and j+1. Gravity pulls all balls but walls.
struct ChainTopology {
  using Model = DimensionlessChain;
  using Flows = ChainFlows;

  const DimensionlessChain& model;
  const ContactLayout& at;

  /// An approach is one difference: equal velocities leave no rounding.
  double rest_speed() const { return 0; }
  double approach(ConstState x, Index j) const { return x[at.velocity[j]] - x[at.velocity[j + 1]]; }
  double drive(Index j) const { return model.gravity[j + 1] - model.gravity[j]; }
  double acceleration(Index i) const { return -model.gravity[i]; }
  double coupling(Index j, Index i) const { return -model.inverse_mass[std::max(j, i)]; }

  /// A wall between passes nothing on: what touches behind it is then pressed by nothing, without effect.
  template <class Use>
  void for_each_near(Index j, Use&& use) const {
    if (j + 1 < at.contacts()) use(j + 1);
    if (j > 0) use(j - 1);
  }
  template <class Use>
  void for_each_direction(Index j, Use&& use) const {
    use(at.velocity[j], -1.0);
    use(at.velocity[j + 1], 1.0);
  }
  template <class Use>
  void for_each_push(Index j, Use&& use) const {
    use(at.velocity[j], -model.inverse_mass[j]);
    use(at.velocity[j + 1], model.inverse_mass[j + 1]);
  }
};

}  // namespace mariotte::model
