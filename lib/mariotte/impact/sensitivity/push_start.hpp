// Slopes as series where contacts start from δ = 0, for one instruction set: depths are t^e Σ sᵢ zⁱ, with e =
// 0 what comes from their slopes, and with e = 1 what comes from those of their rates and from the forces.
// Both have forces t^{e + 1/2} zⁱ, which give depths t^{e + 5/2} zⁱ, t^{5/2} being one or two powers of z.
#pragma once
#include "mariotte/impact/sensitivity/push_clock.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

template <int N>
class StartSeries {
 public:
  using Pack = Lanes<N>;

  using Rows = std::vector<Row<N>>;

  void expand(const Forces& forces, const Columns<N>& columns, int e, Rows& rows) {
    const int shift = static_cast<int>(std::lround(2.5 / forces.series->power)), last = forces.series->order;
    rows.resize(forces.contact.size());
    for (std::size_t j = 0; j < rows.size(); ++j) {
      std::fill_n(rows[j].depth, last, Pack(0.0));
      rows[j].depth[0] = e == 0 ? columns.contact[j].depth : columns.contact[j].rate;
    }
    for (int i = 0; i < last; ++i) {
      for (std::size_t j = 0; j < rows.size(); ++j) push(forces, columns, e, j, i, rows);
      for (std::size_t j = 0; i + shift < last && j < rows.size(); ++j)
        rows[j].depth[i + shift] = depth(forces, columns, e, j, i, rows);
    }
  }

 private:
  MARIOTTE_SERIES_INLINE void push(const Forces& forces, const Columns<N>& columns, int e, std::size_t j,
                                   int i, Rows& rows) const {
    const Powers powers{e + 0.5, forces.series->power};
    const auto& force = forces.contact[j];
    auto& r = rows[j];
    Pack slope = r.by_depth.next(force.by_depth, r.depth, i);
    if (e == 1 && force.has_spring) slope += force.spring[i] * columns.contact[j].stiffness;
    r.impulse[i] = powers.once(i) * slope;
    r.travel[i] = powers.twice(i) * r.impulse[i];
  }

  MARIOTTE_SERIES_INLINE Pack depth(const Forces& forces, const Columns<N>& columns, int e, std::size_t j,
                                    int i, const Rows& rows) const {
    Pack sum(0.0);
    for (const auto& effect : columns.on_depth[j])
      effect.add_to(sum, rows[effect.by].travel[i], e * forces.contact[effect.by].travel[i]);
    return sum;
  }
};

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
