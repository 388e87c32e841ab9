// What is looked at while a microbody moves: states at events, peaks and samples.
#pragma once
#include <vector>

#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/watch/due_samplings.hpp"
#include "mariotte/impact/watch/peaks.hpp"
#include "mariotte/model/microbody/microbody_system.hpp"

namespace mariotte::impact {

/// Dimensionless state → SI. `height` and spin follow from it.
BodyState body_state(const model::MicrobodySystem& system, double time, ConstState x);

/// The state at the beginning of each phase, which is that at the event before it.
struct Milestone {
  double time;
  std::vector<double> state;
};

/// Largest push, pull and indentation of each tip since its last touch, dimensionless.
struct TipPeaks {
  double push = 0, pull = 0, depth = 0;
};
inline constexpr std::array all_tip_peaks = {&TipPeaks::push, &TipPeaks::pull, &TipPeaks::depth};
static_assert(sizeof(TipPeaks) == all_tip_peaks.size() * sizeof(double), "every peak is in the list");

/// Sees every step of a body's run and keeps what the result needs.
class MicrobodyObserver final : public hybrid::PhaseObserver {
 public:
  /// Both must outlive this.
  MicrobodyObserver(const model::MicrobodySystem& system, const RunObserver& observers);
  void begin_phase(double time, ConstState x) override;
  void observe(const flow::Step& step) override;
  void passed(double time, Index events) override {
    tell(observers_, time * system_.body().scale.time, events);
  }
  bool gives_up() const override { return impact::gives_up(observers_); }
  /// The last samples.
  void finish(double time, ConstState x);

  const std::vector<Milestone>& milestones() const { return milestones_; }
  /// Per phase and tip, in the order of the milestones.
  const std::vector<std::vector<TipPeaks>>& peaks() const { return peaks_; }
  /// Two tips stuck at once in a way that leaves the division of friction between them open.
  bool shared_friction() const { return shared_friction_; }
  BodyTrace take_trace() { return std::move(trace_); }

 private:
  TipPeaks now(ConstState x, Index tip) const;
  void search(const flow::Step& step, Index tip);
  void sample(double time, ConstState x);

  const model::MicrobodySystem& system_;
  const RunObserver& observers_;
  bool shared_friction_ = false;
  double start_ = 0;
  std::vector<Milestone> milestones_;
  std::vector<std::vector<TipPeaks>> peaks_;
  BodyTrace trace_;
  std::vector<double> inside_;
  DueSamplings due_;
};

}  // namespace mariotte::impact
