// What is looked at while contacts that form one system move.
#pragma once
#include "mariotte/impact/watch/due_samplings.hpp"
#include "mariotte/impact/watch/peaks.hpp"
#include "mariotte/impact/watch/trace.hpp"
#include "mariotte/impact/watch/turning.hpp"

namespace mariotte::impact {

/// Finds peaks and, if asked to, keeps a trace, takes samples and tells how far the run is.
class ContactWatch final : public hybrid::PhaseObserver {
 public:
  /// All must outlive this; `times` are the natural ones of the contacts, dimensionless.
  ContactWatch(const model::ContactPhase& phase, const Scale& scale, std::span<const double> times,
               const RunObserver& observers)
      : trace(phase, scale),
        phase_(phase),
        scale_(scale),
        observers_(observers),
        due_(observers, scale, phase.velocities(), times) {
    peaks.begin(phase);
  }
  void begin_phase(double time, ConstState x) override {
    start_ = time;
    if (observers_.trace) trace.begin_phase(time, x);
  }
  void observe(const flow::Step& step) override {
    peaks.observe(step);
    if (turning) turning->observe(step);
    if (observers_.trace) trace.observe(start_, step);
    due_.take_within(start_, step, [&](ConstState x) { return Reading{phase_, x}; });
  }
  /// The last samples.
  void finish(double time, ConstState x) { due_.take_all(time, Reading{phase_, x}); }
  void passed(double time, Index events) override { tell(observers_, time * scale_.time, events); }
  bool gives_up() const override { return impact::gives_up(observers_); }

  PeakObserver peaks;
  TraceObserver trace;
  std::optional<TurningObserver> turning = {};  ///< where directions could turn

 private:
  struct Reading {
    const model::ContactPhase& phase;
    ConstState x;

    double velocity(Index i) const { return phase.velocity(x, i); }
    double gap(Index j) const { return phase.gap(x, j); }
    double force(Index j) const { return phase.felt_force(x, j); }
  };

  const model::ContactPhase& phase_;
  const Scale& scale_;
  const RunObserver& observers_;
  DueSamplings due_;
  double start_ = 0;
};

}  // namespace mariotte::impact
