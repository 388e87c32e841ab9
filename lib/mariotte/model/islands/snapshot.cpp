#include "mariotte/model/islands/snapshot.hpp"

#include <algorithm>

namespace mariotte::model {

Snapshot::Snapshot(const FreeBalls& balls, const std::vector<int>& owner,
                   const std::vector<std::unique_ptr<Island>>& islands, const hybrid::Options& options)
    : balls_(balls),
      owner_(owner),
      islands_(islands),
      accuracy_(options.accuracy),
      requested_(options.flow) {}

void Snapshot::move_to(Instant t) {
  now_ = t;
  seen_.clear();
}

ConstState Snapshot::follow(std::size_t island, flow::Problem& phase) {
  const auto& one = *islands_[island];
  const double elapsed = now_ - one.clock;
  if (followed_.size() <= island) followed_.resize(island + 1);
  auto& so_far = followed_[island];
  if (!(so_far.clock == one.clock) || so_far.start != one.start || so_far.elapsed > elapsed)
    so_far = {one.clock, one.start, one.start, 0};
  if (const double rest = elapsed - so_far.elapsed; rest > 0) {
    std::vector<Index> fired;
    flows_.choose(phase, requested_)
        .flow.follow(phase, so_far.state, {.limit = rest, .accuracy = accuracy_}, fired);
    so_far.elapsed = elapsed;
  }
  return so_far.state;
}

const Snapshot::Seen& Snapshot::see(int island) {
  const auto known =
      std::find_if(seen_.begin(), seen_.end(), [&](const Seen& s) { return s.island == island; });
  if (known != seen_.end()) return *known;
  const auto number = static_cast<std::size_t>(island);
  auto& one = *islands_[number];
  auto mode = one.held;
  auto& phase = one.system.problem(mode);
  const auto x = follow(number, phase);
  auto& seen =
      seen_.emplace_back(Seen{.island = island, .first = one.first, .velocity = {}, .gap = {}, .force = {}});
  const auto& layout = one.system.layout();
  for (const Index at : layout.velocity) seen.velocity.push_back(x[at]);
  for (const Index at : layout.gap) seen.gap.push_back(x[at]);
  for (Index j = 0; j < layout.contacts(); ++j) seen.force.push_back(phase.felt_force(x, j));
  return seen;
}

const Snapshot::Seen* Snapshot::around(Index j) {
  const int island = owner_[j];
  return island >= 0 && island == owner_[j + 1] ? &see(island) : nullptr;
}

double Snapshot::velocity(Index ball) {
  const int island = owner_[ball];
  if (island < 0) return balls_.velocity(ball, now_);
  const auto& seen = see(island);
  return seen.velocity[ball - seen.first];
}

double Snapshot::gap(Index contact) {
  const auto* seen = around(contact);
  return seen ? seen->gap[contact - seen->first] : balls_.gap(contact, now_);
}

double Snapshot::force(Index contact) {
  const auto* seen = around(contact);
  return seen ? seen->force[contact - seen->first] : 0;
}

}  // namespace mariotte::model
