// How the field and the guards of a chain or a network move with its parameters, at a fixed state.
//
// Masses, laws and directions of the models at the points of the stencil give slopes once, before the run.
// Along the run the slope of a force is that of a formula: analytic for power laws, and by the stencil for
// all others and for what a contact remembers.
#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "mariotte/impact/sensitivity/coefficient_slopes.hpp"
#include "mariotte/impact/sensitivity/force_slope.hpp"
#include "mariotte/impact/sensitivity/late_damping.hpp"
#include "mariotte/impact/sensitivity/push_slopes.hpp"
#include "mariotte/impact/sensitivity/slope_matrix.hpp"
#include "mariotte/impact/sensitivity/stencil.hpp"
#include "mariotte/model/contacts/contact_system.hpp"

namespace mariotte::impact {

/// The model at point k of a stencil, in the units of the base model.
template <class Scaled>
struct ShiftedModel {
  const Scaled& model;
  Index column;  ///< of the parameter
  double step;
  std::span<const StencilPoint> points;
  std::size_t k;

  bool is_first() const { return k == 0; }
  bool is_last() const { return k + 1 == points.size(); }
  /// dF/dp is the sum over all points of what F differs from that of the base, times this.
  double share() const { return points[k].weight / step; }
};

/// Of a model with P parameters. `peak` is what contacts remember, by contact and parameter; the run moves
/// it.
template <class Topology>
class ContactVariation {
 public:
  using Scaled = typename Topology::Model;

  ContactVariation(const Scaled& model, const model::ContactLayout& layout, Index columns, double accuracy);
  /// All points of every parameter, in their order.
  void add(const ShiftedModel<Scaled>& shifted);

  Index columns() const { return columns_; }
  /// Slopes that are a hundredth of a state over its parameter.
  const std::vector<double>& natural_slopes() const { return natural_; }
  /// Gaps, which grow as long as balls fly: they do not tell how large slopes are.
  std::vector<Index> places() const { return layout_.gap; }
  /// Energies: nothing depends on them, and no outcome is one.
  std::vector<Index> unneeded() const;
  /// Carry slopes along a step that is known as a formula; false if it is not.
  bool advance(const flow::Step& step, const contact::ContactSet& mode, SlopeMatrix& slopes) const {
    return push_slopes_.advance(step, mode, slopes);
  }
  /// Notices contacts that turn next to where they would yield or close.
  void see(const flow::Step& step, const contact::ContactSet& mode) const;
  /// By contact: how far from that, in natural indentations.
  const std::vector<double>& near_yield() const { return near_yield_; }
  const std::vector<double>& near_closing() const { return near_closing_; }
  /// ∂f/∂p at a state.
  void source(ConstState x, const contact::ContactSet& mode, SlopeMatrix& b) const;
  /// ∂f/∂x. A linear contact that touches at rest is pressed, however little.
  void jacobian(const flow::Problem& problem, ConstState x, const contact::ContactSet& mode,
                State values) const;
  /// ∂γ/∂x of guard i along a direction of the state.
  double guard_rate(const flow::Problem& problem, Index i, ConstState x, ConstState dx,
                    const contact::ContactSet&) const {
    guard_rates_.resize(problem.guard_count());
    problem.guard_rates(x, dx, guard_rates_);
    return guard_rates_[i];
  }
  /// ∂γ/∂p of guard i at a state, by parameter.
  void guard_slopes(Index i, ConstState x, const contact::ContactSet& mode, std::span<double> slopes) const;
  /// What directions that move do to the approach of contact j at a state.
  double rate_slope(Index j, Index column, ConstState x) const;
  /// How fast guard i crosses at this rate, relative to what is natural.
  double crossing_speed(Index i, double rate, const contact::ContactSet& mode) const;
  /// In which what guard i watches moves by its own size.
  double natural_time(Index i) const { return model_.time[layout_.guard_contact[i]]; }
  /// Whose guard it is.
  std::string name(Index i, const contact::ContactSet&) const {
    return "contact " + std::to_string(layout_.guard_contact[i] + 1);
  }
  /// Guards of contacts that touch and approach at the start: they have just closed.
  std::vector<Index> guards_at_start(const contact::ContactSet& mode, ConstState x) const;
  /// The mode before guard i has fired at the start.
  void open_at_start(contact::ContactSet& mode, Index i) const { mode[i] = contact::ContactMode::open; }
  /// Guards beside those that have fired: loads of contacts that creep and let go at the same instant, as far
  /// as rounding can tell.
  std::vector<Index> unmet(const std::vector<Index>& fired, const contact::ContactSet& before,
                           const contact::ContactSet& after) const;
  /// Whether its contact has closed by guard i.
  bool closes(Index i, const contact::ContactSet& before, const contact::ContactSet& after) const {
    const Index j = layout_.guard_contact[i];
    return before[j] == contact::ContactMode::open && after[j] == contact::ContactMode::closed;
  }
  /// By how much of their size slopes are off where its contact closes by the clock of another one.
  double lost_at_onset(Index i) const { return lost_at_contact(model_.law[layout_.guard_contact[i]]); }
  /// By the clock of guard i, where it is a gap, that is where its law begins, without what rounding leaves
  /// of a long flight.
  void place_gap(Index i, ConstState x, const contact::ContactSet& mode, SlopeMatrix& slopes) const {
    if (layout_.kind(i) != model::GuardKind::gap) return;
    std::vector<double> level(columns_);
    guard_slopes(i, x, mode, level);
    for (Index c = 0; c < columns_; ++c) slopes(layout_.gap[layout_.guard_contact[i]], c) = -level[c];
  }
  /// How large slopes of velocities by a parameter are in natural units, at least as its own.
  double reach(const SlopeMatrix& slopes, Index column) const;
  /// How large slopes of the gap of guard i are beside those of velocities, in natural units: where its
  /// contact closes by the clock of another one, forces take as much from what is left of them later.
  double gap_reach(Index i, const SlopeMatrix& slopes) const;
  /// Whether nothing pushes.
  bool is_free(const contact::ContactSet& mode) const {
    for (Index j = 0; j < layout_.contacts(); ++j)
      if (contact::carries_force(mode[j])) return false;
    return true;
  }
  /// Whether slopes of the force grow faster than δ^{−1/2} towards guard i.
  bool ends_steeply(Index i, const contact::ContactSet& mode) const;
  /// Where guard i has changed what its contact remembers: to the indentation at that event, whose slopes are
  /// those of the gap at fixed time and of the time.
  void remember(Index i, const contact::ContactSet& before, const contact::ContactSet& after,
                const SlopeMatrix& slopes, ConstState rate, std::span<const double> time);
  /// Whether slopes of the force may grow without bound where guard i is met: a load that vanishes does so
  /// while its contact is indented. Those of a linear contact do not, so its slopes stay at the instant of
  /// the state, however little before or behind the root that is.
  bool has_root(Index i, const contact::ContactSet&) const {
    if (layout_.kind(i) != model::GuardKind::gap) return false;
    return !contact::is_linear(model_.law[layout_.guard_contact[i]]);
  }
  /// Whether a force may begin as a power: that of a linear contact is smooth from its onset on.
  bool may_begin_steeply(const contact::ContactSet& mode) const {
    for (Index j = 0; j < layout_.contacts(); ++j)
      if (contact::carries_force(mode[j]) && !contact::is_linear(model_.law[j])) return true;
    return false;
  }
  /// The state at which guard i is zero, next to one where it nearly is: roots of rounding are much.
  void meet(Index i, const contact::ContactSet& mode, State x) const;
  /// A contact closes and opens exactly where its law begins and ends: if it pulls there, a little beyond.
  void settle(Index i, const contact::ContactSet& before, State x) const;

 private:
  /// What a contact pushes, and what moves it.
  struct Directions {
    PlacedCoefficients push, direction;
  };

  void read(const Scaled& model, Index j, Directions& directions) const;
  void add_directions(Index j, const ShiftedModel<Scaled>& shifted);
  void add_law(Index j, const ShiftedModel<Scaled>& shifted);
  void set_power(Index j, LawSlope& law) const;
  void add_force(Index j, ConstState x, const contact::ContactSet& mode, SlopeMatrix& b) const;
  std::optional<double> turning_point(const flow::Step& step, Index j) const;
  double left_to_yield(const flow::Step& step, Index j, const contact::ContactSet& mode) const;

  const Scaled& model_;
  const model::ContactLayout& layout_;
  Index columns_;
  std::vector<double> natural_;
  std::vector<ContactSlope> contact_;
  mutable std::vector<double> pressed_;  ///< a state, as its slopes see it
  mutable std::vector<double> guard_rates_;
  mutable std::vector<double> near_yield_, near_closing_;
  SlopeMatrix acceleration_;             ///< by velocity and parameter
  SlopeMatrix peak_;                     ///< by parameter and contact
  std::vector<Directions> base_;         ///< by contact
  Directions moved_;                     ///< of one contact in another model
  std::vector<contact::Law> first_law_;  ///< at the first point of a stencil
  mutable PushSlopes<Topology> push_slopes_;
};

}  // namespace mariotte::impact
