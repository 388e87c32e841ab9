// Moving a steady wave on by whole periods instead of following it.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "mariotte/model/islands/islands.hpp"
#include "mariotte/model/islands/repeated_changes.hpp"

namespace mariotte::model {

namespace {

/// A row that is shorter is passed by the time a wave in it has become steady.
constexpr Index worthwhile = 5 * wave_stride;
/// Crests of a wave that are looked at before it counts as one that does not become steady.
constexpr Index patience = 256;

/// What a wave may still change: rounding, or a hundredth of what cannot be told from rest.
double tolerance_of_steady(const DimensionlessChain& chain) {
  return std::max(256 * epsilon, 0.01 * chain.noise_speed / chain.speed);
}

}  // namespace

/// A row that waits on one side is long enough, and the wave has not been looked at for long.
bool Islands::may_become_steady(const Island& island) const {
  if (requested_ || crests_ > patience || (island.log && !island.log->can_repeat())) return false;
  const auto waits = [&](Index shift) {
    return count_waiting(
               {.first = island.first, .last = island.last, .shift = shift, .period = 0, .count = 0},
               worthwhile) == worthwhile;
  };
  return waits(wave_stride) || waits(-wave_stride);
}

/// Compare the crest that the island has passed, if it did, with one `wave_stride` contacts before.
std::optional<Repetition> Islands::find_repetition(Island& island) {
  if (!island.may_be_steady || !island.crest.has_seen()) return std::nullopt;
  ++crests_;
  auto now = stamp_of(island);
  const auto before = island.stamp;
  const Index shift = now.crest - before.crest;
  if (before.crest >= 0 && std::abs(shift) < wave_stride) return std::nullopt;
  island.stamp = now;
  if (before.crest < 0 || std::abs(shift) > wave_stride) return std::nullopt;
  const Repetition found{.first = island.first,
                         .last = island.last,
                         .shift = shift,
                         .period = now.time - before.time,
                         .count = 0};
  const bool is_steady = shows_same_wave(before, now, tolerance_of_steady(chain_)) && leaves_rest(found);
  return is_steady && is_alone(found, before.changes) ? std::optional(found) : std::nullopt;
}

WaveStamp Islands::stamp_of(const Island& island) const {
  return {.crest = island.first + island.crest.contact(),
          .first = island.first,
          .time = island.crest_from + island.crest.time(),
          .state = island.crest.state(),
          .changes = run_.changes.size()};
}

/// Balls that the wave has passed in the last period are as slow as what it may still change.
bool Islands::leaves_rest(const Repetition& wave) const {
  const bool forward = wave.shift > 0;
  const Index rear = forward ? wave.first - wave.shift : wave.last + 1,
              ahead = forward ? wave.last : wave.first;
  if (rear < 0 || rear + std::abs(wave.shift) > std::ssize(owner_)) return false;
  const double rest = balls_.velocity(ahead, now_), slow = tolerance_of_steady(chain_) * chain_.speed;
  for (Index i = rear; i < rear + std::abs(wave.shift); ++i)
    if (owner_[i] >= 0 || std::abs(balls_.velocity(i, now_) - rest) > slow) return false;
  return true;
}

/// Since so many changes all that has happened did so where the wave was, and balls that it left behind will
/// not meet.
bool Islands::is_alone(const Repetition& wave, std::size_t since) const {
  const Index first = std::max<Index>(0, std::min(wave.first, wave.first - wave.shift) - 1);
  const Index last = std::min(balls_.contacts(), std::max(wave.last, wave.last - wave.shift) + 1);
  for (Index j = first; j < last; ++j)
    if (queue_.has_meeting(j)) return false;
  return std::all_of(run_.changes.begin() + since, run_.changes.end(), [&](const auto& timed) {
    return timed.change.contact >= first && timed.change.contact < last;
  });
}

/// The wave of an island just dissolved into the range to be cut moves on as far as the row that waits for it
/// is the same, before anything else happens.
void Islands::move_on(Island& island, Repetition wave) {
  const Index most = std::min(periods_in_peace(wave.period), periods_in_events());
  wave.count = (count_waiting(wave, most * wave_stride + 1) - 1) / wave_stride;
  if (std::abs(wave.way()) <= wave.last - wave.first) return;
  record();
  if (island.log) island.log->repeat(wave);
  repeat_changes(wave, now_, run_);
  balls_.repeat(wave, now_);
  now_ = now_ + static_cast<double>(wave.count) * wave.period;
  from_ += wave.way();
  to_ += wave.way();
  island.stamp = {};
  crests_ = 0;
  count_.moved_on += std::abs(wave.way());
}

/// Whole periods before something happens elsewhere, somebody looks, or the run ends.
Index Islands::periods_in_peace(double period) {
  double until = options_.max_time;
  if (const auto* next = queue_.next()) until = std::min(until, next->time.value);
  if (observer_) until = std::min(until, observer_->next_look());
  const double periods = std::floor((until - now_.value) / period) - 1;
  return static_cast<Index>(std::clamp(periods, 0.0, static_cast<double>(balls_.contacts())));
}

Index Islands::periods_in_events() const {
  constexpr Index of_a_contact = 4;
  return std::max<Index>(0, options_.max_events - run_.events) / (of_a_contact * wave_stride);
}

/// How many contacts ahead of the wave, at most `most`, are equal to those that it has passed and touch at
/// rest.
Index Islands::count_waiting(const Repetition& wave, Index most) const {
  const Index step = wave.shift > 0 ? 1 : -1, edge = wave.shift > 0 ? wave.last - 1 : wave.first;
  const Index behind = wave.first - wave.shift, behind_last = wave.last - wave.shift;
  if (std::min(behind, behind_last) < 0 || std::max(behind, behind_last) > balls_.contacts()) return 0;
  const auto is_as_before = [&](Index j) { return are_equal(chain_, j, -wave.shift); };
  for (Index j = wave.first; j < wave.last; ++j)
    if (!is_as_before(j)) return 0;
  const auto state = balls_.state();
  Index count = 0;
  for (Index j = edge + step; count < most && j >= 0 && j < balls_.contacts(); j += step, ++count) {
    const bool rests = balls_.modes()[j] == contact::ContactMode::touching &&
                       balls_.gap(j) == balls_.gap(edge + step) && state.approach(j) == 0;
    if (!rests || !is_as_before(j)) break;
  }
  return count;
}

}  // namespace mariotte::model
