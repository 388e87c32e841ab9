// One mode of bodies as what flows follow.
#pragma once
#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mariotte/flow/free_motion.hpp"
#include "mariotte/flow/problem.hpp"
#include "mariotte/flow/recorded/recorded_phase.hpp"
#include "mariotte/model/bodies/bodies_balls.hpp"
#include "mariotte/model/bodies/bodies_cluster.hpp"
#include "mariotte/model/bodies/bodies_field.hpp"

namespace mariotte::model {

template <int D>
struct Approach;

/// D = 2 or 3. Guards: five of each slot, the gap of each contact that is watched, the parting of those that
/// touch at rest, then how far bodies have gone since near pairs were listed.
template <int D>
class BodiesPhase final : public flow::Problem, public flow::FreeMotion, public flow::RecordedPhase {
 public:
  BodiesPhase(const BodiesSetting<D>& setting, Index touching);

  /// Follow this mode from now on; it must outlive the phase's use.
  void bind(const BodiesMode& mode);
  const BodiesLayout<D>& layout() const { return layout_; }

  Index size() const override { return layout_.size(); }
  void derivative(ConstState x, State dx) const override;
  Index guard_count() const override { return escape_guard(escapes_); }
  void guards(ConstState x, State values) const override;
  void derivative_and_guards(ConstState x, State dx, State values) const override;
  void guard_rates(ConstState x, ConstState dx, State rates) const override;
  std::span<const flow::Crossing> crossings() const override { return crossing_; }
  std::span<const double> magnitudes() const override { return magnitude_; }
  double time_scale() const override { return time_; }
  std::vector<flow::Entry> pattern() const override { return entries(); }
  void jacobian(ConstState x, State values) const override;
  double damping_group() const override { return damping_; }
  Index trial_steps() const override { return trial_steps_; }
  double least_load(double) const override { return infinity; }
  bool is_ballistic() const override { return ballistic_; }
  void second_derivative(ConstState, State) const override {}
  const flow::FreeMotion* free_motion() const override { return ballistic_ ? this : nullptr; }
  const flow::RecordedPhase* recorded() const override { return recordable_ ? this : nullptr; }
  flow::Accepted accept(ConstState x) override;
  std::string component(Index index) const override;

  double first_meeting(ConstState x, double limit, double window, std::vector<Index>& fired) const override;
  void fly(ConstState x, double t, State result) const override;
  /// Of bodies in flight: whether some contact closes, ever, but for those that only drift.
  bool comes_together(ConstState x) const;
  /// The same of bodies whose flight has no closed form: no two come near each other any more, by spheres
  /// about their mass centres, nor one a plane.
  bool flies_apart(ConstState x) const;

  void record(ConstState x, double accuracy, bool all, flow::Recording& recording) const override;
  bool stays_far(ConstState x, double time, ConstState moves) const override;
  void fly_others(ConstState x, double t, State result) const override;
  flow::BallPhase* balls() const override { return is_balls_ ? &*balls_ : nullptr; }
  flow::ClusterPhase* cluster() const override { return is_cluster_ ? &*cluster_ : nullptr; }

  /// Guards where a field of this mode has been evaluated.
  template <class T, class N>
  void slot_guards(const BodiesField<T, D, N>& field, std::size_t i, std::span<T> values) const;
  template <class T, class N>
  void guards_of(const BodiesField<T, D, N>& field, std::span<T> values) const;
  Index slot_guard(Index slot, SlotGuard guard) const {
    return slot * guards_per_slot + static_cast<Index>(guard);
  }
  /// Of the k-th contact that is watched; all of them are, unless the mode has a list of near ones.
  Index gap_guard(Index k) const { return layout_.slots * guards_per_slot + k; }
  Index watched(Index k) const { return watches_near_ ? mode_->near[k] : k; }
  /// Place of a contact among them, or −1.
  Index place_watched(Index contact) const {
    if (!watches_near_) return contact;
    const auto place = std::lower_bound(mode_->near.begin(), mode_->near.end(), contact);
    return place != mode_->near.end() && *place == contact ? place - mode_->near.begin() : Index{-1};
  }
  Index watched_count() const {
    return watches_near_ ? std::ssize(mode_->near) : std::ssize(setting_.contact);
  }
  Index parting_guard(Index k) const { return gap_guard(watched_count()) + k; }
  /// Of body k, which leaves the place where near pairs were listed.
  Index stray_guard(Index k) const { return parting_guard(touching_) + k; }
  /// Of the k-th contact that is watched, in such a flight: its gap says that these spheres are apart.
  Index escape_guard(Index k) const { return stray_guard(strays_) + k; }

 private:
  const std::vector<flow::Entry>& entries() const;
  template <class T>
  double cap_noise(const ClosedContact& mode, const ContactMotion<T, D>& motion) const;
  template <class T, class N>
  T friction_guard(const BodiesField<T, D, N>& field, const ClosedContact& mode,
                   const ContactForces<T, D>& c) const;
  template <class T, class N>
  T load_guard(const BodiesField<T, D, N>& field, const ClosedContact& mode,
               const ContactForces<T, D>& c) const;
  Approach<D> approach(ConstState x, Index contact) const;
  double open_gap(const Approach<D>& both, Index contact) const;
  double swinging_meeting(ConstState x, const Approach<D>& both, Index contact, double gap,
                          double limit) const;
  double meeting(ConstState x, Index contact, double limit) const;
  bool drifts(ConstState x, Index contact) const;
  /// Depth at which a contact that is open closes.
  double closing_depth(Index contact) const {
    return model::closing_depth(setting_.contact[contact].law, memory_of(*mode_, contact));
  }
  /// Beyond it spheres about the mass centres, which hold both bodies, are apart.
  double escape_gap(Index contact) const;
  bool can_be_recorded(const ClosedContact& mode) const;
  bool is_stuck_at_the_end(ConstState x) const;
  void weigh_direction(std::size_t closed);
  flow::Accepted leave_rest(std::size_t closed);
  void set_crossings();
  void set_crossings(const ClosedContact& one);
  void set_stiffness();
  void find_balls();
  void find_far(ConstState x, bool all) const;
  void find_followed() const;
  void release_springs(ConstState x) const;
  void record_guards(flow::Recording& recording) const;
  void record_contacts(double accuracy, flow::Recording& recording) const;

  const BodiesSetting<D>& setting_;
  Index touching_;
  const BodiesMode* mode_ = nullptr;
  bool watches_near_ = false;
  Index strays_ = 0, escapes_ = 0;
  BodiesLayout<D> layout_;
  bool at_peace_ = false, ballistic_ = false, free_flight_ = true, recordable_ = false;
  Index steps_at_rest_ = 0;  ///< of slips that have not left it
  Index accepted_ = 0;       ///< steps, in all phases
  double time_ = 1, damping_ = 0;
  Index trial_steps_ = 0;
  std::vector<flow::Crossing> crossing_;
  std::vector<double> magnitude_;

  bool is_balls_ = false, is_cluster_ = false;
  mutable std::optional<BodiesBalls> balls_;  ///< in the plane
  mutable std::optional<BodiesCluster> cluster_;

  mutable BodiesField<double, D> field_;
  mutable BodiesField<series::Dual<double, 1>, D> directional_;
  mutable BodiesField<Sloped, D> sloped_;
  mutable BodiesField<series::Traced, D> traced_;
  mutable std::vector<series::Traced> traced_x_, traced_dx_, traced_values_;
  mutable std::vector<std::pair<double, Index>> meetings_;  ///< of contacts in flight, in time
  mutable std::vector<char> is_far_;                        ///< by watched contact: its gap is not recorded
  mutable std::vector<double> reach_;                       ///< of bodies within a step
  mutable std::vector<char> is_followed_;                   ///< by body: it touches another, or may meet one
  mutable std::vector<Index> followed_;                     ///< components of the state
  mutable std::vector<series::Dual<double, 1>> along_, along_values_;
  mutable std::vector<Sloped> sloped_x_, sloped_dx_;
  mutable std::vector<flow::Entry> entries_;  ///< of the Jacobian in this mode; empty if nobody has asked
  mutable std::vector<Index> colours_;        ///< of its columns
};

}  // namespace mariotte::model
