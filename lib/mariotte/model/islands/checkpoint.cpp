#include "mariotte/model/islands/checkpoint.hpp"

#include <utility>

#include "mariotte/model/islands/islands.hpp"

namespace mariotte::model {

std::size_t Checkpoint::bytes() const {
  std::size_t sum = balls.bytes() + queue.bytes() + owner.size() * sizeof(int);
  for (const auto& one : island) sum += sizeof one + one.start.size() * sizeof(double) + one.held.size();
  return sum;
}

Islands::Islands(const DimensionlessChain& chain, const ChainLayout& layout, const Checkpoint& from,
                 const hybrid::Options& options, bool stay, IslandObserverMaker make_log)
    : Islands(chain, layout, from.balls, options, stay, std::move(make_log)) {
  now_ = from.now;
  owner_ = from.owner;
  unused_ = from.unused;
  queue_ = from.queue;
  most_steps_ = from.most_steps;
  for (const auto& one : from.island) static_cast<IslandStart&>(add_island()) = one;
}

Checkpoint Islands::checkpoint() const {
  Checkpoint made{now_, balls_, owner_, {}, unused_, queue_, most_steps_};
  for (const auto& island : islands_) made.island.push_back(*island);
  for (const Index id : unused_) made.island[id] = {};
  return made;
}

}  // namespace mariotte::model
