// Those who look at every step of a run.
#pragma once
#include "mariotte/impact/watch/peaks.hpp"
#include "mariotte/impact/watch/trace.hpp"

namespace mariotte::impact {

/// Finds peaks and, if asked to, keeps samples.
class Observers final : public hybrid::PhaseWatcher {
 public:
  Observers(const model::ContactPhase& phase, const Scale& scale, bool trace)
      : recorder(phase, scale), trace_(trace) {
    peaks.begin(phase);
  }
  void begin_phase(double time, ConstState) override { start_ = time; }
  void watch(const flow::Step& step) override {
    peaks.watch(step);
    if (trace_) recorder.watch(start_, step);
  }

  PeakWatcher peaks;
  TraceRecorder recorder;

 private:
  bool trace_;
  double start_ = 0;
};

}  // namespace mariotte::impact
