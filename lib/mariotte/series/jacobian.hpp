// Jacobian of a field from the field itself.
#pragma once
#include "mariotte/series/dual.hpp"

namespace mariotte::series {

/// Element [i][j] is the slope of row i along state j.
template <class Field, class V>
std::array<States<Field, V>, Field::rows> jacobian(const States<Field, V>& x, const Parameters<Field, V>& p) {
  using D = Dual<V, Field::states>;
  States<Field, D> state;
  Parameters<Field, D> parameter;
  for (int j = 0; j < Field::states; ++j) {
    state[j] = D(x[j], {});
    state[j].slope[j] = V(1.0);
  }
  for (int j = 0; j < Field::parameters; ++j) parameter[j] = D(p[j], {});
  const Rows<Field, D> row = Field::rates(state, parameter);
  std::array<States<Field, V>, Field::rows> result;
  for (int i = 0; i < Field::rows; ++i) result[i] = row[i].slope;
  return result;
}

}  // namespace mariotte::series
