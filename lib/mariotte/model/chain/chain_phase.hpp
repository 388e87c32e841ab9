// The smooth field of a chain while its contact set stays as it is [Acary 2003, eq. 2 and 9].
#pragma once
#include "mariotte/model/chain/chain_layout.hpp"
#include "mariotte/model/contacts/contact_automaton.hpp"
#include "mariotte/model/contacts/contact_phase.hpp"

namespace mariotte::model {

/// Guards 0 … n−2 are the gaps. Each damped contact has one more, its load k δ + c δ̇, in the order of the
/// contacts.
struct ChainGuards {
  std::vector<Index> load;     ///< guard of contact j's load, or ChainLayout::absent
  std::vector<Index> contact;  ///< contact of every guard
};

/// Fills `guards`, whose memory is reused.
void make_guards(const ChainLayout& layout, ChainGuards& guards);

/// A closed contact so shallow, and moving so slowly, that its end would be an event made of noise: it has
/// let go.
bool has_faded(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x, Index contact);

/// A touching contact has left the noise.
bool has_loaded(const DimensionlessChain& chain, const ChainLayout& layout, ConstState x, Index contact);

/// Edges of a slice beyond which the chain goes on. A contact nearer than `margin` to such an edge must not
/// push: what it would push on is not there.
struct SliceEdges {
  bool left = false;
  bool right = false;
  Index margin = 0;
};

/// A chain bound to a mode; `bind` moves it on to the next.
class ChainPhase final : public ContactPhase {
 public:
  /// For a chain and layout that outlive it; `reset` when they have changed.
  ChainPhase(const DimensionlessChain& chain, const ChainLayout& layout) : chain_(chain), layout_(layout) {}
  void reset();
  /// For a slice: phases end where a touching contact at such an edge is loaded.
  void set_edges(SliceEdges edges);
  SliceEdges edges() const { return edges_; }

  /// From now on follow `mode`, which must outlive the phase; accepted steps turn its touching contacts
  /// closed.
  void bind(contact::ContactSet& mode);

  Index size() const override { return layout_.size; }
  void derivative(ConstState x, State dx) const override;
  Index guard_count() const override { return static_cast<Index>(guards_.contact.size()); }
  void guards(ConstState x, State values) const override;
  void guard_rates(ConstState x, ConstState dx, State rates) const override;
  std::span<const flow::Crossing> crossings() const override { return crossings_; }
  std::span<const double> magnitudes() const override { return magnitudes_; }
  double time_scale() const override { return time_scale_; }
  std::vector<flow::Entry> pattern() const override;
  void jacobian(ConstState x, State values) const override;
  double damping_ratio() const override;
  bool is_ballistic() const override { return active_ == 0 && !any_law_; }
  void second_derivative(ConstState x, State ddx) const override;
  const flow::SerialPhase* serial() const override { return any_law_ ? nullptr : &serial_; }
  flow::Accepted accept(ConstState x) override;
  std::string component(Index index) const override { return component_name(layout_, index); }

  const contact::ContactSet& mode() const override { return *mode_; }
  Index velocities() const override { return layout_.balls(); }
  Index contacts() const override { return layout_.contacts(); }
  double velocity(ConstState x, Index i) const override { return x[layout_.velocity[i]]; }
  double gap(ConstState x, Index j) const override { return x[layout_.gap[j]]; }
  double approach(ConstState x, Index j) const override {
    return x[layout_.velocity[j]] - x[layout_.velocity[j + 1]];
  }
  contact::Force force(ConstState x, Index j) const override;
  bool is_damped(Index j) const override { return layout_.work[j] != ChainLayout::absent; }

 private:
  double guard(ConstState x, Index i) const;
  double guard_rate(ConstState x, ConstState dx, Index i) const;
  double level(Index i) const;
  void watch(Index j);
  bool is_at_edge(Index j) const;

  const DimensionlessChain& chain_;
  const ChainLayout& layout_;
  ChainGuards guards_;
  std::vector<double> magnitudes_;
  std::vector<flow::Crossing> crossings_;
  flow::SerialPhase serial_;
  SliceEdges edges_;
  contact::ContactSet* mode_ = nullptr;
  Index active_ = 0;      ///< contacts that carry force
  bool any_law_ = false;  ///< a contact whose law is no power law is not open: only CVODE follows it
  double time_scale_ = 1;
};

}  // namespace mariotte::model
