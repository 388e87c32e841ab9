// How the forces of contacts accelerate each other's indentations.
#pragma once
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::flow {

/// δ̈_j = Σ weight_i f_near(i) + outside forces, over first[j] ≤ i < first[j+1]: the matrix −G M⁻¹ Gᵀ by rows.
struct Coupling {
  std::vector<int> first = {0}, near;
  std::vector<double> weight;

  void clear() {
    first.assign(1, 0);
    near.clear();
    weight.clear();
  }
  /// One term more of the last row, which `end_row` completes.
  void add(Index contact, double by_force) {
    near.push_back(static_cast<int>(contact));
    weight.push_back(by_force);
  }
  void end_row() { first.push_back(static_cast<int>(near.size())); }
};

}  // namespace mariotte::flow
