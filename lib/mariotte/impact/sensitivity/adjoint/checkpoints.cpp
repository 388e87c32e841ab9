#include "mariotte/impact/sensitivity/adjoint/checkpoints.hpp"

#include <iterator>
#include <limits>
#include <utility>

namespace mariotte::impact {

void Checkpoints::add(MotionCheckpoint&& one) {
  const auto bytes = one.state.bytes();
  if (!all_.try_emplace(one.before.parts, std::move(one)).second) return;
  bytes_ += bytes;
  while (bytes_ > most_bytes_) erase(least_missed());
}

void Checkpoints::erase(ByParts::iterator one) {
  bytes_ -= one->second.state.bytes();
  all_.erase(one);
}

/// Without it least is to be recorded at once.
Checkpoints::ByParts::iterator Checkpoints::least_missed() {
  auto least = all_.begin();
  std::size_t before = 0, fewest = std::numeric_limits<std::size_t>::max();
  for (auto one = all_.begin(); one != all_.end(); ++one) {
    const auto next = std::next(one) == all_.end() ? one : std::next(one);
    const auto missed = next->second.before.bytes - before;
    if (missed < fewest) least = one, fewest = missed;
    before = one->second.before.bytes;
  }
  return least;
}

const MotionCheckpoint* Checkpoints::last_before(Index number) {
  while (!all_.empty() && all_.rbegin()->first >= number) erase(std::prev(all_.end()));
  return all_.empty() ? nullptr : &all_.rbegin()->second;
}

void CheckpointObserver::passed(double, Index) {
  const auto now = memory_.progress();
  if (now.bytes - last_.bytes < memory_.most_bytes() / 2) return;
  last_ = now;
  checkpoints_.add({now, run_.checkpoint()});
}

}  // namespace mariotte::impact
