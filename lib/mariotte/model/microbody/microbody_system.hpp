// A microbody as a hybrid system; the automaton of a tip is the table in microbody_mode.hpp.
#pragma once
#include <array>
#include <vector>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/model/microbody/microbody_phase.hpp"

namespace mariotte::model {

/// Satisfies hybrid::HybridSystem. Dimensionless; `body().scale` leads back.
class MicrobodySystem {
 public:
  using Mode = MicrobodyMode;
  using Change = MicrobodyChange;

  /// With `balance` the state holds what damping and friction have taken, and positions.
  MicrobodySystem(const Microbody& body, double accuracy, bool balance, WatchedSigns watched = {});
  MicrobodySystem(const MicrobodySystem&) = delete;
  MicrobodySystem& operator=(const MicrobodySystem&) = delete;

  const DimensionlessMicrobody& body() const { return body_; }
  /// The one asked for, or what rounding leaves of it.
  double accuracy() const { return accuracy_; }
  const MicrobodyLayout& layout() const { return layout_; }
  const Mechanics& mechanics() const { return phase_.mechanics(); }

  /// Tips that touch and approach close at 0+.
  void mode_at(ConstState x, Mode& mode, std::vector<Change>& changes) const;
  void transition(Mode& mode, const std::vector<Index>& fired, ConstState x,
                  std::vector<Change>& changes) const;
  /// Captured, or clear after the last impact that was asked for.
  bool is_over(const Mode& mode, ConstState x, bool impacted) const;
  hybrid::Ending ending(const Mode& mode) const;
  void finish(Mode& mode, std::vector<Change>& changes) const;
  MicrobodyPhase& problem(const Mode& mode);
  /// The mode that `problem` was asked for last.
  const Mode& mode() const { return phase_.mode(); }

 private:
  void close(Mode& mode, Index tip, ConstState x, std::vector<Change>& changes) const;
  bool slides(Index i, ConstState x) const;
  void grip(Mode& mode, const std::array<bool, 2>& closed, ConstState x, std::vector<Change>& changes) const;
  void choose_friction(Mode& mode, Index tip, ConstState x, double noise, std::vector<Change>& changes) const;
  void start_from_rest(TipMode& tip, Index i, const Vector3& direction, ConstState x) const;
  bool force_has_turned(const TipMode& tip, Index i, ConstState x) const;
  void go_on(TipMode& tip, Index i, ConstState x) const;
  void hold_or_release(Mode& mode, ConstState x, std::vector<Change>& changes) const;
  void pass(TipGuard guard, Mode& mode, Index tip, ConstState x, std::vector<Change>& changes) const;
  void open_parted(Mode& mode, const std::vector<Index>& fired, ConstState x,
                   std::vector<Change>& changes) const;
  void touch_or_open(Mode& mode, Index tip, ConstState x, std::vector<Change>& changes) const;
  bool slips_on(Index tip, ConstState x) const;
  bool has_escaped(const Mode& mode, ConstState x) const;
  void flip_unnamed_forces(Mode& mode, const std::vector<Index>& fired, ConstState x,
                           std::vector<Change>& changes) const;
  void flip_force(Mode& mode, Index tip, std::vector<Change>& changes) const;
  void release(Mode& mode, Index tip, ConstState x, std::vector<Change>& changes) const;
  /// Friction that would hold this tip, the others being as they are.
  Vector3 needed_friction(Mode mode, Index tip, ConstState x) const;

  DimensionlessMicrobody body_;
  MicrobodyLayout layout_;
  double accuracy_;
  MicrobodyPhase phase_;
};

}  // namespace mariotte::model
