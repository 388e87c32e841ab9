// How the field and the guards of bodies move with their parameters, and what events do to slopes: contacts
// that close begin to be integrated, friction takes up where it sticks or slips, and totals are kept where
// they open.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/bodies/sloped_setting.hpp"
#include "mariotte/impact/sensitivity/slope_matrix.hpp"
#include "mariotte/model/bodies/bodies_system.hpp"

namespace mariotte::impact {

/// Place of a contact among those that are closed, or −1.
inline Index place_of(const model::BodiesMode& mode, Index contact) {
  for (std::size_t i = 0; i < mode.closed.size(); ++i)
    if (mode.closed[i].contact == contact) return static_cast<Index>(i);
  return -1;
}

/// One event: modes, states and rates on both sides of it, and the slopes of its time.
template <int D>
struct BodiesPassage {
  const model::BodiesMode &before, &after;
  ConstState x_before, x_after, rate_before, rate_after;
  const std::vector<Index>& guard;               ///< that tell when it happens
  const std::vector<std::vector<double>>& time;  ///< of each of them, by parameter
};

/// D = 2 or 3.
template <int D>
class BodiesVariation {
 public:
  using Mode = model::BodiesMode;
  using Sloped = model::Sloped;
  using Field = model::BodiesField<Sloped, D, Sloped>;

  BodiesVariation(model::BodiesSystem<D>& system, const std::vector<ShiftedSettings<D>>& shifted);

  Index columns() const { return std::ssize(natural_); }
  const std::vector<double>& natural_slopes() const { return natural_; }
  /// Components that rates depend on, with all rates.
  std::vector<flow::Entry> pattern(const Mode& mode) const;
  /// Components that say where bodies are and how they have turned.
  std::vector<Index> places() const;
  void jacobian(const flow::Problem& problem, ConstState x, const Mode& mode, State values) const;
  void source(ConstState x, const Mode& mode, SlopeMatrix& b) const;
  double guard_rate(const flow::Problem& problem, Index i, ConstState x, ConstState dx,
                    const Mode& mode) const;
  void guard_slopes(Index i, ConstState x, const Mode& mode, std::span<double> slopes) const;
  double crossing_speed(Index i, double rate, const Mode& mode) const;
  std::string name(Index i, const Mode& mode) const;

  std::vector<Index> guards_at_start(const Mode& mode, ConstState x) const;
  void open_at_start(Mode& mode, Index i) const;
  /// Where a contact opens forces end as a power, and a direction where a slip in space comes to rest. Other
  /// guards are left where a run has told them, within the noise that it allows them.
  bool has_root(Index i, const Mode& mode) const;
  /// Whether a force may begin as a power, or a slip in space from rest.
  bool may_begin_steeply(const Mode& mode) const;
  void meet(Index, const Mode&, State) const {}
  void settle(Index, const Mode&, State) const {}

  /// False if slopes do not move its time.
  bool has_time(Index i, const Mode& mode) const;
  /// Guards that tell when an event happens, of those that have fired: a contact that opens does so where its
  /// gap says, though a guard of its friction may have fired within rounding of that.
  std::vector<Index> telling(const std::vector<Index>& fired, const Mode& before, const Mode& after) const;
  /// Contact of a guard, or −1.
  Index contact_of(Index i, const Mode& mode) const;
  /// Slopes behind an event, from those before it.
  SlopeMatrix pass(const BodiesPassage<D>& event, const SlopeMatrix& slopes);
  /// Slopes where a run starts, of contacts that touch and stick.
  void start(const Mode& mode, ConstState x, SlopeMatrix& slopes) {
    if (comes_to_rest({}, mode)) stop_slip(mode, x, slopes);
  }
  /// A mode begins, with slopes at fixed time since then.
  void begin(const Mode& before, const Mode& after, ConstState x, const SlopeMatrix& slopes);
  /// Of what a contact has exchanged in periods that have ended: ∫f_n, ∫f_t, three losses.
  const SlopeMatrix& totals(Index contact) const { return totals_[contact]; }
  /// By how much of their size slopes of what its spring has lost while it faded may be off.
  double faded(Index contact) const { return faded_[contact]; }
  /// Its numbers with the slopes by a parameter, which is lane `column % slope_lanes` of them.
  const SlopedSetting<D>& numbers(Index column) const { return setting_[column / model::slope_lanes]; }
  /// True if a slip has left rest in space and slopes do not know how its first direction moves.
  bool has_unknown_way() const { return has_unknown_way_; }
  /// By parameter, whether it gives a contact a slip that has closed without and slips.
  const std::vector<bool>& one_sided() const { return one_sided_; }

 private:
  std::vector<Index> active(const Mode& mode) const;
  const std::vector<double>& time_of(const BodiesPassage<D>& event, Index contact) const;
  void keep_totals(const BodiesPassage<D>& event, const SlopeMatrix& slopes);
  void see_fading(const BodiesPassage<D>& event);
  void pass_slot(const BodiesPassage<D>& event, const model::ClosedContact& one, const SlopeMatrix& slopes,
                 SlopeMatrix& result);
  /// The field with slopes by parameters from the first on.
  Field& evaluate(Index first, const Mode& mode, ConstState x, const SlopeMatrix& slopes) const;
  /// Whether a contact sticks rigidly that has slipped, or not acted.
  bool comes_to_rest(const Mode& before, const Mode& after) const;
  void stop_slip(const Mode& mode, ConstState x, SlopeMatrix& slopes);
  void see_landings(const Mode& before, const Mode& after, ConstState x, const SlopeMatrix& slopes);
  bool set_way(Index place, const Mode& mode, const Mode& held, ConstState x, const SlopeMatrix& slopes);
  void begin_at_zero(const BodiesPassage<D>& event);
  std::vector<double> rates_behind(const BodiesPassage<D>& event, Index guard) const;
  void open_contact(Mode& mode, Index contact) const;

  model::BodiesSystem<D>& system_;
  std::vector<double> natural_;
  model::BodiesSetting<D> base_;
  std::vector<SlopedSetting<D>> setting_;  ///< by so many parameters
  mutable std::vector<Field> field_;
  mutable model::BodiesField<Sloped, D> base_field_;
  mutable std::vector<Sloped> x_, dx_, guard_;
  std::vector<SlopeMatrix> totals_;
  std::vector<double> faded_;
  bool has_unknown_way_ = false;
  std::vector<bool> one_sided_;
};

}  // namespace mariotte::impact
