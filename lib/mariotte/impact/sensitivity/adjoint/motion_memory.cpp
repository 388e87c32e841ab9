#include "mariotte/impact/sensitivity/adjoint/motion_memory.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace mariotte::impact {

MotionMemory::MotionMemory(Index contacts, std::size_t most_bytes)
    : most_bytes_(most_bytes), seen_(contacts, 0), waiting_(contacts, 0), left_(contacts + 1, {-infinity}) {}

MotionMemory::MotionMemory(Index contacts, std::size_t most_bytes, const Edge& until, const Progress& before)
    : MotionMemory(contacts, most_bytes) {
  until_ = until;
  first_ = before.parts;
  progress_ = before;
}

std::optional<Index> MotionMemory::wanted(const MotionRecord::Stretch& stretch) const {
  if (!until_) return std::nullopt;
  const auto& edge = until_->stretch;
  const bool is_it = stretch.first == edge.first && stretch.last == edge.last && stretch.begin == edge.begin;
  return is_it ? std::optional(edge.part) : std::nullopt;
}

std::optional<MotionMemory::Edge> MotionMemory::edge() const {
  if (first_ == 0) return std::nullopt;
  return Edge{first_, motion_.stretch.front()};
}

/// Contacts that the stretch has taken in first.
void MotionMemory::note_waiting(const MotionRecord::Stretch& last_part) {
  constexpr double same = 1e-9;  // in units of a short contact
  const auto& [first, last] = std::pair(last_part.first, last_part.last);
  const auto balls = std::span(left_).subspan(first, last - first + 1);
  // The island has been there before, and has only been cut anew.
  const bool goes_on =
      std::any_of(balls.begin(), balls.end(), [&](Instant time) { return last_part.begin - time < same; });
  for (Index j = first; j < last; ++j)
    if (!std::exchange(seen_[j], 1)) waiting_[j] = goes_on;
  std::fill(balls.begin(), balls.end(), last_part.end);
}

void MotionMemory::add(Index missing, const MotionRecord& parts) {
  note_waiting(parts.stretch.back());
  const Index number = progress_.parts + missing;
  progress_.parts = number + std::ssize(parts.stretch);
  progress_.bytes += parts.bytes() + missing * (parts.bytes() / parts.stretch.size());
  if (until_ && number >= until_->number) return;
  if (missing > 0) {
    motion_ = {};
    first_ = number;
  }
  append(motion_, parts);
  if (motion_.bytes() <= most_bytes_) return;
  const Index held = std::ssize(motion_.stretch), left_out = held / 2;
  motion_ = part_of(motion_, left_out, held);
  first_ += left_out;
}

}  // namespace mariotte::impact
