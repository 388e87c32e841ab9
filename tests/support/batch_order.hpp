// The order in which scenes are put into a batch.
#pragma once
#include <numeric>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::test {

inline std::vector<Index> in_order(std::size_t count) {
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

/// So many between two calls of `finish`.
template <class Batch, class Scene>
void put_all(Batch& batch, const std::vector<Scene>& scenes, double accuracy, const std::vector<Index>& order,
             Index at_once) {
  for (Index i = 0; i < std::ssize(order); ++i) {
    batch.put(order[i], scenes[order[i]], {.accuracy = accuracy});
    if (i % at_once == at_once - 1) batch.finish();
  }
  batch.finish();
}

}  // namespace mariotte::test
