// What is looked at while contacts that form one system move.
#pragma once
#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/impact/watch/peaks.hpp"
#include "mariotte/impact/watch/trace.hpp"

namespace mariotte::impact {

/// Finds peaks and, if asked to, keeps samples and tells how far the run is.
class ContactWatch final : public hybrid::PhaseWatcher {
 public:
  /// All three must outlive this.
  ContactWatch(const model::ContactPhase& phase, const Scale& scale, const Observers& observers)
      : recorder(phase, scale), scale_(scale), observers_(observers) {
    peaks.begin(phase);
  }
  void begin_phase(double time, ConstState) override { start_ = time; }
  void watch(const flow::Step& step) override {
    peaks.watch(step);
    if (observers_.trace) recorder.watch(start_, step);
  }
  void passed(double time, Index events) override { tell(observers_, time * scale_.time, events); }

  PeakWatcher peaks;
  TraceRecorder recorder;

 private:
  const Scale& scale_;
  const Observers& observers_;
  double start_ = 0;
};

}  // namespace mariotte::impact
