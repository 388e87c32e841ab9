// The smooth field of a network while its contact set stays as it is: M v̇ = Gᵀ f, ġ = G v.
#pragma once
#include "mariotte/model/contacts/contact_automaton.hpp"
#include "mariotte/model/contacts/contact_phase.hpp"
#include "mariotte/model/network/network_layout.hpp"

namespace mariotte::model {

/// A network bound to a mode. Where its contacts are those of bodies in one row, −1 and +1 in two freedoms
/// each, the flows made for rows can follow it; where not, natural modes of linked contacts can.
class NetworkPhase final : public ContactPhase {
 public:
  /// For a network and layout that outlive it.
  NetworkPhase(const DimensionlessNetwork& network, const NetworkLayout& layout);
  /// From now on follow `mode`, which must outlive the phase; accepted steps turn its touching contacts
  /// closed.
  void bind(contact::ContactSet& mode);

  Index size() const override { return layout_.size; }
  void derivative(ConstState x, State dx) const override;
  Index guard_count() const override { return std::ssize(layout_.guard_contact); }
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
  const flow::SerialPhase* serial() const override { return row_.empty() || any_law_ ? nullptr : &serial_; }
  const flow::LinkedPhase* linked() const override { return row_.empty() && !any_law_ ? &linked_ : nullptr; }
  flow::Accepted accept(ConstState x) override;
  std::string component(Index index) const override { return component_name(layout_, index); }

  const contact::ContactSet& mode() const override { return *mode_; }
  Index velocities() const override { return layout_.freedoms; }
  Index contacts() const override { return layout_.contacts; }
  double velocity(ConstState x, Index i) const override { return x[i]; }
  double gap(ConstState x, Index j) const override { return x[layout_.gap(j)]; }
  double approach(ConstState x, Index j) const override { return -gap_rate(network_.direction[j], x); }
  contact::Force force(ConstState x, Index j) const override;
  bool is_damped(Index j) const override { return layout_.work[j] != NetworkLayout::absent; }

  /// A closed contact so shallow, and parting so slowly, that its end would be an event made of noise.
  bool has_faded(ConstState x, Index j) const;
  /// A contact that touched at rest and was pulled apart instead of pressed.
  bool has_parted(ConstState x, Index j) const;

 private:
  double guard(ConstState x, Index i) const;
  double guard_rate(ConstState x, ConstState dx, Index i) const;
  double level(Index i) const;
  void watch(Index j);
  bool has_loaded(ConstState x, Index j) const;

  const DimensionlessNetwork& network_;
  const NetworkLayout& layout_;
  std::vector<double> magnitudes_;
  std::vector<flow::Crossing> crossings_;
  std::vector<Index> row_;    ///< by contact: its place in the row; empty if the network is none
  flow::SerialPhase serial_;  ///< unless it is none
  flow::LinkedPhase linked_;  ///< if it is none
  contact::ContactSet* mode_ = nullptr;
  Index active_ = 0;
  bool any_law_ = false;  ///< a contact whose law is no power law is not open: only CVODE follows it
  double time_scale_ = 1;
};

}  // namespace mariotte::model
