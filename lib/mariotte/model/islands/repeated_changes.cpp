#include "mariotte/model/islands/repeated_changes.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace mariotte::model {
namespace {

using Changes = std::vector<hybrid::Timed<ContactChange>>;

/// A change of a contact that the wave has left behind: the how-manieth of that contact, and when, in periods
/// from now.
struct PastChange {
  ContactChange change;
  Index number;
  double whole, part;
};

/// What happened at contacts when the wave passed them.
struct Past {
  std::vector<PastChange> left_behind;  ///< in the last period, in order of `part`
  std::vector<Index> seen;              ///< by contact of the wave: changes so far
};

/// Number of contacts between the rear of the wave and contact j; negative behind it.
Index from_rear(const Repetition& of, Index j) {
  return of.shift > 0 ? j - of.first : of.last - 1 - j;
}

Past past(const Repetition& of, Instant now, const Changes& changes) {
  const Index length = std::abs(of.shift), width = of.last - of.first;
  const double since = now.value - of.period * (2 + static_cast<double>(width) / static_cast<double>(length));
  auto from = changes.end();
  while (from != changes.begin() && std::prev(from)->time >= since) --from;
  Past found{.left_behind = {}, .seen = std::vector<Index>(width + length)};
  for (; from != changes.end(); ++from) {
    const Index place = from_rear(of, from->change.contact);
    if (place < -length || place >= width || from->change.after == contact::ContactMode::touching) continue;
    const Index number = found.seen[place + length]++;
    const double ago = (from->time - now.value) / of.period, whole = std::floor(ago);
    if (place < 0) found.left_behind.push_back({from->change, number, whole, ago - whole});
  }
  found.seen.erase(found.seen.begin(), found.seen.begin() + length);
  std::stable_sort(found.left_behind.begin(), found.left_behind.end(),
                   [](const auto& a, const auto& b) { return a.part < b.part; });
  return found;
}

/// True if the change that is the `number`-th of a contact so far from the rear comes while the wave moves
/// on.
bool is_to_come(const Past& past, Index place, Index way, Index number) {
  const Index width = std::ssize(past.seen);
  if (place < way) return place >= width || number >= past.seen[place];
  return place < way + width && number < past.seen[place - way];
}

}  // namespace

void repeat_changes(const Repetition& of, Instant now, hybrid::Trajectory<ContactChange>& run) {
  const auto past = model::past(of, now, run.changes);
  const Index way = std::abs(of.way()), length = std::abs(of.shift);
  const double rounds = static_cast<double>(of.count + std::ssize(past.seen) / length + 2);
  double earliest = 0, last = -1;
  for (const auto& known : past.left_behind) earliest = std::min(earliest, known.whole);
  for (double round = earliest + 1; round <= rounds; ++round)
    for (const auto& known : past.left_behind) {
      const auto periods = static_cast<Index>(round - known.whole);
      auto change = known.change;
      change.contact += periods * of.shift;
      if (periods < 1 || !is_to_come(past, from_rear(of, change.contact), way, known.number)) continue;
      const double elapsed = std::clamp(round + known.part, 0.0, static_cast<double>(of.count));
      run.changes.push_back({(now + elapsed * of.period).value, change});
      run.events += run.changes.back().time != last;
      last = run.changes.back().time;
    }
}

}  // namespace mariotte::model
