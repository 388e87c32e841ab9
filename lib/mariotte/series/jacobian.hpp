// Jacobian of a field from the field itself.
#pragma once
#include "mariotte/series/dual.hpp"

namespace mariotte::series {

/// Element [i][j] is the slope of row i along state j.
template <class Field, class V>
std::array<States<Field, V>, rows_of<Field>> jacobian(const States<Field, V>& x,
                                                      const Parameters<Field, V>& p) {
  using D = Dual<V, states_of<Field>>;
  States<Field, D> state;
  Parameters<Field, D> parameter;
  for (int j = 0; j < states_of<Field>; ++j) {
    state[j] = D(x[j], {});
    state[j].slope[j] = V(1.0);
  }
  for (int j = 0; j < Field::parameters; ++j) parameter[j] = D(p[j], {});
  const Values<Field, D> row = Field::rates(state, parameter);
  std::array<States<Field, V>, rows_of<Field>> result;
  for (int i = 0; i < rows_of<Field>; ++i) result[i] = row[i].slope;
  return result;
}

}  // namespace mariotte::series
