// A wave that has become steady repeats itself to the last digit, so it need not be followed.
//
// A row of equal balls that is struck sends a solitary wave along. What is not of its shape stays behind, a
// part of it with each ball, and after some fifty balls nothing of it is left. From then on the wave is as it
// was some balls before whenever a contact is pressed most.
#pragma once
#include <vector>

#include "mariotte/core/instant.hpp"
#include "mariotte/flow/flow.hpp"
#include "mariotte/model/chain/chain_system.hpp"

namespace mariotte::model {

/// Balls after which a wave is compared with itself: rows that repeat themselves after 1, 2, 3, 4, 6 or 12
/// balls have their waves.
inline constexpr Index wave_stride = 12;

/// An island when a contact was pressed most.
struct WaveStamp {
  Index crest = -1;  ///< that contact
  Index first = 0;   ///< ball of the island
  Instant time;
  std::vector<double> state;
  std::size_t changes = 0;  ///< of the run so far
};

/// True if two stamps show one wave: velocities and gaps, relative to the largest, differ by `tolerance` at
/// most, and balls beyond what both show move as slowly. The states are v₁ g₁ v₂ g₂ … vₙ.
bool shows_same_wave(const WaveStamp& before, const WaveStamp& now, double tolerance);

/// True of an elastic contact that stiffens: waves of others spread or fade.
bool lets_waves_be_steady(const contact::Law& law);

/// Balls j and j + `shift`, and the contacts j and j + `shift` behind them, are equal and let waves be
/// steady.
bool are_equal(const DimensionlessChain& chain, Index j, Index shift);

/// Notes in a stretch of an island when the most pressed of its contacts that are still loading is pressed
/// most.
class CrestObserver final : public flow::StepObserver {
 public:
  /// Another observer sees the same steps; it may be null.
  void begin(const ChainSystem& slice, ConstState start, flow::StepObserver* other);
  void observe(const flow::Step& step) override;
  bool has_slopes() const override { return other_ && other_->has_slopes(); }

  bool has_seen() const { return time_ >= 0; }
  Index contact() const { return contact_; }
  double time() const { return time_; }  ///< from the start of the stretch
  const std::vector<double>& state() const { return state_; }

 private:
  double rate(ConstState x) const;

  const ChainLayout* layout_ = nullptr;
  flow::StepObserver* other_ = nullptr;
  Index contact_ = -1;
  double time_ = -1;
  std::vector<double> state_;
};

}  // namespace mariotte::model
