// Bodies as the event loop sees them: modes, transitions and endings.
#pragma once
#include "mariotte/hybrid/system.hpp"
#include "mariotte/model/bodies/bodies_phase.hpp"

namespace mariotte::model {

/// When a run is over.
enum class Over { separated, at_time_limit };

/// D = 2 or 3. Satisfies hybrid::HybridSystem.
template <int D>
class BodiesSystem {
 public:
  using Mode = BodiesMode;
  using Change = BodiesChange;

  /// Of validated bodies of that dimension, which outlive it.
  BodiesSystem(const Bodies& bodies, BodiesSetting<D> setting, Over over);
  BodiesSystem(const BodiesSystem&) = delete;

  const BodiesSetting<D>& setting() const { return setting_; }
  /// As many slots as the state has.
  BodiesLayout<D> layout(ConstState x) const;

  void mode_at(std::vector<double>& x, Mode& mode, std::vector<Change>& changes) const;
  void transition(Mode& mode, const std::vector<Index>& fired, std::vector<double>& x,
                  std::vector<Change>& changes) const;
  bool is_over(const Mode& mode, ConstState x, bool impacted) const;
  hybrid::Ending ending(const Mode& mode) const {
    return mode.closed.empty() ? hybrid::Ending::separated : hybrid::Ending::bound;
  }
  void finish(Mode&, std::vector<Change>&) const {}
  BodiesPhase<D>& problem(const Mode& mode);

  /// What the state leads to in a mode; valid until the next call.
  const BodiesField<double, D>& field(const Mode& mode, ConstState x) const;
  /// How a contact moves, whatever the mode.
  ContactMotion<double, D> motion(Index contact, ConstState x) const {
    return contact_motion(setting_, layout(x), setting_.contact[contact], x);
  }
  GapMotion<double, D> approach(Index contact, ConstState x) const {
    return gap_motion(setting_, layout(x), setting_.contact[contact], x);
  }

 private:
  static constexpr double soon = 1e-10;  ///< just after the beginning, in natural times of a contact

  void close(Mode& mode, Index contact, std::vector<double>& x, BodyEvent event,
             std::vector<Change>& changes) const;
  void open(Mode& mode, std::size_t place, std::vector<double>& x, std::vector<Change>& changes) const;
  void sink(const ClosedContact& one, const GapMotion<double, D>& now, std::vector<double>& x) const;
  void begin_branch(ClosedContact& one, const GapMotion<double, D>& now) const;
  /// A force begins at its onset, or in a contact that has been slack.
  enum class Start { onset, grip };
  void begin_friction(Mode& mode, std::size_t place, Start start, std::vector<double>& x,
                      std::vector<Change>& changes) const;
  void hold_since_grip(const Mode& mode, std::size_t place, std::vector<double>& x) const;
  void put_spring(const ClosedContact& one, const ContactForces<double, D>& now,
                  const Vec<double, D>& stretch, std::vector<double>& x) const;
  bool begins_to_stick(const Mode& mode, std::size_t place, Start start, ConstState x) const;
  void begin_from_rest(Mode& mode, std::size_t place, std::vector<double>& x, BodyEvent otherwise,
                       std::vector<Change>& changes) const;
  void begin_at_rest(ClosedContact& one, ConstState x) const;
  void arrest(const Mode& mode, std::vector<double>& x) const;
  bool leaves_rest(const Mode& mode, std::size_t place, ConstState x) const;
  bool slip_from_rest(Mode& mode, std::size_t place, const ContactForces<double, D>& held,
                      std::vector<double>& x) const;
  void slip_along(ClosedContact& one, const Vec<double, D>& direction, const Vec<double, D>& normal,
                  std::vector<double>& x) const;
  void pass_guard(Index guard, const std::vector<Index>& touching, Mode& mode, std::vector<double>& x,
                  std::vector<Change>& changes) const;
  void pass_slot(SlotGuard guard, Mode& mode, std::size_t place, std::vector<double>& x,
                 std::vector<Change>& changes) const;
  void pass_friction(Mode& mode, std::size_t place, std::vector<double>& x,
                     std::vector<Change>& changes) const;
  void put_back_to_cap(const ClosedContact& one, const ContactForces<double, D>& now,
                       std::vector<double>& x) const;
  void break_loose(Mode& mode, std::size_t place, const ContactForces<double, D>& now, std::vector<double>& x,
                   std::vector<Change>& changes) const;
  double held_at_the_end(const Mode& mode, std::size_t place, ConstState x) const;
  double held_by_spring(const ClosedContact& one, ConstState x) const;
  double held_at_the_cap(const Mode& mode, std::size_t place, ConstState x) const;
  void open_parted(Mode& mode, std::vector<double>& x, std::vector<Change>& changes) const;
  void slacken(Mode& mode, ConstState x, std::vector<Change>& changes) const;
  void stop_yielding(const std::vector<Index>& slots, Mode& mode, std::vector<double>& x,
                     std::vector<Change>& changes) const;
  bool is_yielding(const ClosedContact& one) const;
  bool holds_at_once(const Mode& mode, std::size_t place) const;
  void turn(ClosedContact& one, std::vector<double>& x, std::vector<Change>& changes) const;
  void leave_rest(Mode& mode, ConstState x) const;
  void stay_at_rest(Mode& mode, std::vector<double>& x, std::vector<Change>& changes) const;
  bool sticks_rigidly(const ClosedContact& one) const;
  std::string redundancy(const Mode& mode, ConstState x) const;
  void hold_or_release(Mode& mode, std::vector<double>& x, std::vector<Change>& changes) const;
  bool starts_in_stick(const SettingContact<D>& one, const contact::Memory& past,
                       const ContactMotion<double, D>& now) const;

  const Bodies& bodies_;
  mutable BodiesSetting<D> setting_;  ///< its noise grows with the ways of what closes
  Over over_;
  mutable std::vector<Index> fired_, touching_, yielded_;  ///< of a transition
  mutable BodiesField<double, D> field_;
  mutable BodiesPhase<D> phase_;
};

}  // namespace mariotte::model
