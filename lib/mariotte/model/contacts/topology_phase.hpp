// The smooth field of a chain or a network while its contact set stays as it is, M v̇ = Gᵀ f + M a, ġ = G v
// [Acary 2003, eq. 2 and 9].
#pragma once
#include "mariotte/model/contacts/contact_modes.hpp"
#include "mariotte/model/contacts/contact_phase.hpp"

namespace mariotte::model {

/// Contacts bound to a mode; `bind` moves them on to the next. Topology::Flows is what the flows that need
/// more than a field see of them, as long as every contact that is not open follows a law or a branch that
/// is a sum of powers.
template <class Topology>
class TopologyPhase final : public ContactPhase {
 public:
  using Model = typename Topology::Model;

  /// For a model and a layout that outlive it; `reset` when they have changed.
  TopologyPhase(const Model& model, const ContactLayout& layout) : topology_{model, layout} {}
  void reset();
  typename Topology::Flows& flows() { return flows_; }
  const typename Topology::Flows& flows() const { return flows_; }

  /// From now on follow `mode`, which must outlive the phase; accepted steps turn its touching contacts
  /// closed. `ends_bound`: it is over once adhesion holds together for ever what has come to rest.
  void bind(contact::ContactSet& mode, bool ends_bound);
  /// Contact j of the mode has opened, and nothing else has changed.
  void open(Index j) {
    watch(j);
    count_active();
  }
  /// Contacts that carry force.
  Index active() const { return active_; }

  Index size() const override { return at().size; }
  void derivative(ConstState x, State dx) const override;
  Index guard_count() const override { return std::ssize(at().guard_contact); }
  void guards(ConstState x, State values) const override;
  void guard_rates(ConstState x, ConstState dx, State rates) const override;
  std::span<const flow::Crossing> crossings() const override { return crossings_; }
  std::span<const double> magnitudes() const override { return magnitudes_; }
  double time_scale() const override { return time_scale_; }
  std::vector<flow::Entry> pattern() const override;
  void jacobian(ConstState x, State values) const override;
  double damping_group() const override;
  bool is_ballistic() const override { return active_ == 0 && !needs_field_ && at().drives() == 0; }
  void second_derivative(ConstState x, State ddx) const override;
  const flow::SerialPhase* serial() const override { return needs_field_ ? nullptr : flows_.serial(); }
  const flow::LinkedPhase* linked() const override { return needs_field_ ? nullptr : flows_.linked(); }
  const flow::Drives* drives() const override { return at().drives() > 0 ? &drives_ : nullptr; }
  flow::Accepted accept(ConstState x) override;
  std::string component(Index index) const override { return component_name(at(), index); }

  const contact::ContactSet& mode() const override { return *mode_; }
  Index velocities() const override { return at().velocities(); }
  Index contacts() const override { return at().contacts(); }
  double velocity(ConstState x, Index i) const override { return x[at().velocity[i]]; }
  double gap(ConstState x, Index j) const override { return x[at().gap[j]]; }
  double approach(ConstState x, Index j) const override { return topology_.approach(x, j); }
  contact::Force force(ConstState x, Index j) const override {
    return force(-x[at().gap[j]], topology_.approach(x, j), j);
  }
  contact::Force force(double indentation, double rate, Index j) const override;
  Index gap_place(Index j) const override { return at().gap[j]; }
  bool is_damped(Index j) const override { return has_work(j); }
  bool pulls(Index j) const override { return contact::pulls(law(j)); }

 private:
  const ContactLayout& at() const { return topology_.at; }
  const contact::Law& law(Index j) const { return topology_.model.law[j]; }
  bool has_work(Index j) const { return at().work[j] != ContactLayout::absent; }
  bool goes_slack(Index j) const { return at().load_guard[j] != ContactLayout::absent; }
  bool watches_turns(Index j) const { return at().branch_guard[j] != ContactLayout::absent; }
  contact::Memory past(Index j) const { return memory_of(*mode_, j); }
  bool has_impulse(Index j) const { return at().impulse[j] != ContactLayout::absent; }
  void add_drives(std::vector<flow::Entry>& pattern) const;
  void drive_slopes(ConstState x, State values) const;
  bool is_held(ConstState x) const;
  double clear_load(ConstState x, Index j) const;
  contact::Force load(ConstState x, Index j) const {
    return contact::load(law(j), -x[at().gap[j]], topology_.approach(x, j));
  }
  double level(Index j) const { return levels_[j]; }
  double guard(ConstState x, Index i) const;
  double guard_rate(ConstState x, ConstState dx, Index i) const;
  double slow_turn(Index j) const;
  const SignalPiece& piece(const Signal& signal, Index k) const { return signal.piece[(*mode_).piece[k]]; }
  double next_kink(Index k) const;
  void drive(ConstState x, State dx) const;
  template <class Use>
  void for_each_given(Use&& use) const;
  void watch(Index j);
  void count_active();
  bool follow_branch(Index j);
  void find_magnitudes();
  void find_drives();

  Topology topology_;
  typename Topology::Flows flows_;
  flow::Drives drives_;
  std::vector<double> magnitudes_;
  std::vector<Index> driver_;   ///< by place: the drive that prescribes this velocity, or absent
  std::vector<double> levels_;  ///< by contact: its gap guard is gap + level
  std::vector<flow::Crossing> crossings_;
  std::vector<std::optional<contact::ContactMode>> watched_;  ///< by contact: the mode as which it is watched
  std::vector<WidthBranch> widths_;                           ///< by contact, where its branch is one
  contact::ContactSet* mode_ = nullptr;
  Index active_ = 0;  ///< contacts that carry force
  bool ends_bound_ = false;
  bool needs_field_ = false;  ///< a contact that is not open follows no power
  double time_scale_ = 1;
};

}  // namespace mariotte::model
