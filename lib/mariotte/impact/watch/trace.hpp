// Samples of a run for pictures: one row per step, thinned so that memory stays bounded.
#pragma once
#include "mariotte/core/compensated.hpp"
#include "mariotte/core/scale.hpp"
#include "mariotte/hybrid/simulate.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/watch/observers.hpp"
#include "mariotte/model/contacts/contact_phase.hpp"

namespace mariotte::impact {

/// Keeps the ends of steps and, where a step is long against the contact time, points within; where a force
/// jumps, one row before and one after. Whenever `capacity` rows are full, a quarter of them is dropped:
/// those that are nearest to the line between their neighbours. So a rest of many steps does not cost the
/// impacts before it their rows.
class TraceObserver {
 public:
  static constexpr std::size_t capacity = 4096;

  TraceObserver(const model::ContactPhase& phase, const Scale& scale) : phase_(phase), scale_(scale) {}

  /// Times are absolute and dimensionless.
  void begin_phase(double time, ConstState x);
  /// `start` is the time at which the step's phase began.
  void observe(double start, const flow::Step& step);
  /// The samples, with the state at the ending as the last.
  Trace take(double time, ConstState x);

 private:
  bool jumps(ConstState x) const;
  void keep(double time, ConstState x);

  const model::ContactPhase& phase_;
  const Scale& scale_;
  Trace trace_;
};

/// The trace of a chain of islands: samples at one interval for about as long as a wave takes to cross the
/// chain four times, the interval doubling whenever `capacity` rows are full; later ones at twice the time of
/// the one before.
class SampledTrace {
 public:
  static constexpr std::size_t capacity = 4096;

  /// Keep a sample; how long until the next.
  double take(const Sample& sample);
  Trace take() { return std::move(trace_); }

 private:
  Trace trace_;
  double interval_ = 0;
};

}  // namespace mariotte::impact
