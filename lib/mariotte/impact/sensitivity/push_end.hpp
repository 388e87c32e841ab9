// Slopes at the end of a step, and how right their series are there, for one instruction set.
#pragma once
#include "mariotte/impact/sensitivity/push_columns.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

/// What a contact has given: the slopes, and what they are slopes of.
template <int N>
struct Given {
  Lanes<N> impulse{0.0}, travel{0.0};
  double impulse_itself = 0, travel_itself = 0;
};

template <int N>
struct PushEnd {
  using Pack = Lanes<N>;

  double time = 0;
  std::vector<Given<N>> given;  ///< by contact
  Pack last;                    ///< size of the last terms

  /// Last terms over what they may be.
  double excess(const Columns<N>& columns, const PushExpansion::Bound& bound) const {
    Pack size(0.0);
    for (std::size_t v = 0; v < columns.velocity.size(); ++v)
      size = largest(size, magnitude(velocity(columns, v)));
    double most = 0;
    for (Index c = 0; c < columns.count; ++c) {
      const double natural = bound.natural[columns.first + c];
      const double own = last[c] / (bound.tolerance * std::max(natural, size[c]));
      if (std::isnan(own)) return own;
      most = std::max(most, own);
    }
    return most;
  }

  void tell(const Columns<N>& columns, const PushExpansion::End& to) const {
    for (std::size_t v = 0; v < columns.velocity.size(); ++v) {
      tell(columns, velocity(columns, v), v, to.velocity);
      tell(columns, displacement(columns, v), v, to.displacement);
    }
    for (std::size_t j = 0; j < given.size(); ++j) tell(columns, given[j].impulse, j, to.impulse);
  }

 private:
  Pack velocity(const Columns<N>& columns, std::size_t v) const {
    Pack sum = columns.velocity[v] + time * columns.drive[v];
    for (const auto& effect : columns.on_velocity[v])
      effect.add_to(sum, given[effect.by].impulse, given[effect.by].impulse_itself);
    return sum;
  }
  Pack displacement(const Columns<N>& columns, std::size_t v) const {
    Pack sum = time * (columns.velocity[v] + 0.5 * time * columns.drive[v]);
    for (const auto& effect : columns.on_velocity[v])
      effect.add_to(sum, given[effect.by].travel, given[effect.by].travel_itself);
    return sum;
  }
  static void tell(const Columns<N>& columns, const Pack& values, std::size_t row, SlopeMatrix& to) {
    double* at = &to(static_cast<Index>(row), columns.first);
    for (Index c = 0; c < columns.count; ++c) at[c * to.rows] = values[c];
  }
};

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
