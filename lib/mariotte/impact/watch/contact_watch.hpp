// What is looked at while contacts that form one system move.
#pragma once
#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/impact/watch/peaks.hpp"
#include "mariotte/impact/watch/trace.hpp"

namespace mariotte::impact {

/// Finds peaks and, if asked to, keeps samples and tells how far the run is.
class ContactWatch final : public hybrid::PhaseObserver {
 public:
  /// All three must outlive this.
  ContactWatch(const model::ContactPhase& phase, const Scale& scale, const RunObserver& observers)
      : recorder(phase, scale), scale_(scale), observers_(observers) {
    peaks.begin(phase);
  }
  void begin_phase(double time, ConstState) override { start_ = time; }
  void observe(const flow::Step& step) override {
    peaks.observe(step);
    if (observers_.trace) recorder.observe(start_, step);
  }
  void passed(double time, Index events) override { tell(observers_, time * scale_.time, events); }

  PeakObserver peaks;
  TraceObserver recorder;

 private:
  const Scale& scale_;
  const RunObserver& observers_;
  double start_ = 0;
};

}  // namespace mariotte::impact
