// A run of neighbouring balls that push each other, integrated together on a clock of its own.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "mariotte/core/instant.hpp"
#include "mariotte/flow/flow.hpp"
#include "mariotte/model/chain/chain_system.hpp"
#include "mariotte/model/islands/repetition.hpp"
#include "mariotte/model/islands/steady_wave.hpp"

namespace mariotte::model {

/// Sees the steps of one island. A stretch is followed before it is known that nothing interferes: what was
/// seen counts once it is kept.
class IslandObserver : public flow::StepObserver {
 public:
  /// A stretch of the slice that starts at ball `first` begins at `start`; what was seen and not kept is
  /// void.
  virtual void begin(const ChainSystem& slice, Index first, Instant start) = 0;
  virtual void keep() = 0;
  /// False if every step has to be seen: no wave is moved on.
  virtual bool can_repeat() const { return false; }
  /// What was kept of a wave happens again.
  virtual void repeat(const Repetition&) {}
};
/// Makes the log of one stretch.
using IslandObserverMaker = std::function<std::unique_ptr<IslandObserver>()>;

/// Balls first … last, and where they are for certain. The first and the last fly freely, whatever the others
/// do, unless the chain ends there.
struct IslandStart {
  Index first = 0, last = 0;
  Instant clock;
  std::vector<double> start;
  contact::ContactSet held;
};

struct Island : IslandStart {
  ChainSystem system;  ///< of the slice
  // Where it gets next if nothing interferes.
  std::vector<double> x;
  contact::ContactSet mode;
  std::vector<Index> fired;
  flow::Arrival arrival;
  std::unique_ptr<IslandObserver> log;  ///< null if nobody watches
  // As long as its wave may become steady.
  bool may_be_steady = false;
  CrestObserver crest;  ///< of the last stretch followed,
  Instant crest_from;   ///< which began then
  WaveStamp stamp;

  Index contacts() const { return last - first; }
  Instant arrives() const { return clock + arrival.duration; }
};

/// A contact whose balls do not fly freely, or are about not to.
bool is_active(const ChainState& state, contact::ContactMode mode, Index j);

/// Contacts that do not push between the last that does and the end of an island, at least, where they touch.
/// A row of touching sharp contacts wakes one by one; in a linear one, a step of a series is felt up to half
/// its order ahead. Elsewhere one such contact is enough.
Index margin_of_rows(const DimensionlessChain& chain);

/// The island has what it needs and not much more: its active contacts keep the margin to both ends, and
/// nowhere do many contacts in a row idle.
bool is_well_cut(const Island& island);

/// Neighbouring active contacts first … last, and the margins they need.
struct Group {
  Index first, last;
  Index left_margin, right_margin;
};

/// The groups among contacts from … to, as many as can be islands of their own.
void find_groups(const ChainState& state, const contact::ContactSet& mode, Index from, Index to,
                 Index margin_of_rows, std::vector<Group>& groups);

}  // namespace mariotte::model
