// How the forces of contacts accelerate each other's indentations.
#pragma once
#include <vector>

namespace mariotte::flow {

/// δ̈_j = Σ weight_i f_near(i) + outside forces, over first[j] ≤ i < first[j+1]; the matrix −G M⁻¹ Gᵀ by rows,
/// each with its own contact first.
struct Coupling {
  std::vector<int> first = {0}, near;
  std::vector<double> weight;
};

}  // namespace mariotte::flow
