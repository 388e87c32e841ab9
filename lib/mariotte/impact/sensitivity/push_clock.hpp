// Slopes as series in the clock σ of a step, for one instruction set. With I the slope of a contact's impulse
// and W that of its integral over time
//
//   I' = pace φ,   W' = pace I,   S_δ = S_δ(0) + t S_δ̇(0) + t²/2 S_a + Σ (what contacts do per impulse) W,
//
// and the slope of the rate likewise from I. Where the clock is time, the damper c δⁿ⁻¹ δ̇ = (c/n) d(δⁿ)/dt
// has the slope d(c δⁿ⁻¹ S_δ)/dt: one product tells all of φ. By the exponent of a damped contact that
// closes, slopes are A + ln σ B with two series each: B follows the same equations, and I_A' = pace φ_A −
// I_B/σ.
#pragma once
#include "mariotte/impact/sensitivity/push_columns.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

/// By order, of one contact: slopes of depth and rate, c δⁿ⁻¹ S_δ, slopes of the impulse and of its integral.
template <int N>
struct Row {
  static constexpr int orders = flow::most_orders + 1;
  Lanes<N> depth[orders], rate[orders], damped[orders], impulse[orders], travel[orders];
  Product<N> by_depth, by_rate, paced;  ///< what depth and rate do to the force, and the pace of the impulse

  Row() {}  // nothing is read before it is set
};

template <int N>
class ClockSeries {
 public:
  using Pack = Lanes<N>;
  using Rows = std::vector<Row<N>>;

  /// All of the slopes, or A where there are `logs`.
  void expand(const Forces& forces, const Columns<N>& columns, const Rows* logs, Rows& rows) {
    is_log_ = false;
    forces.series->is_time ? fill<true>(forces, columns, logs, rows)
                           : fill<false>(forces, columns, logs, rows);
  }
  /// B.
  void expand_logs(const Forces& forces, const Columns<N>& columns, Rows& rows) {
    is_log_ = true;
    fill<false>(forces, columns, nullptr, rows);
  }

 private:
  template <bool is_time>
  void fill(const Forces& forces, const Columns<N>& columns, const Rows* logs, Rows& rows) {
    rows.resize(forces.contact.size());
    for (auto& own : rows) own.impulse[0] = own.travel[0] = Pack(0.0);
    for (int i = 0; i < forces.series->order; ++i)
      for (std::size_t j = 0; j < rows.size(); ++j) next<is_time>(forces, columns, logs, rows, j, i);
  }

  /// Order i of depth and rate, and i + 1 of what the force gives.
  template <bool is_time>
  MARIOTTE_SERIES_INLINE void next(const Forces& forces, const Columns<N>& columns, const Rows* logs,
                                   Rows& rows, std::size_t j, int i) const {
    const auto& force = forces.contact[j];
    const auto& series = *forces.series;
    auto& r = rows[j];
    const bool is_whole = is_time && force.is_damped;
    if (i == 0 || !is_whole) r.depth[i] = depth(forces, columns, rows, j, i);
    if (force.is_damped) r.rate[i] = rate(forces, columns, rows, j, i);
    Pack growth = is_whole ? by_damped(force, r, i) : by_motion(force, r, i);
    add_law(force, columns.contact[j], i, growth);
    Pack way = is_time ? r.impulse[i] : r.paced.next(series.pace, r.impulse, i);
    if (logs) growth += -(*logs)[j].impulse[i + 1], way += -(*logs)[j].travel[i + 1];
    r.impulse[i + 1] = reciprocal.of[i + 1] * growth;
    r.travel[i + 1] = reciprocal.of[i + 1] * way;
  }

  /// What depth and rate do to the force.
  static MARIOTTE_SERIES_INLINE Pack by_motion(const Force& force, Row<N>& r, int i) {
    Pack sum = r.by_depth.next(force.by_depth, r.depth, i);
    if (force.is_damped) sum += r.by_rate.next(force.by_rate, r.rate, i);
    return sum;
  }
  /// The same where the rate is that of the depth, of which order i + 1 is known then.
  static MARIOTTE_SERIES_INLINE Pack by_damped(const Force& force, Row<N>& r, int i) {
    if (i == 0) r.damped[0] = r.by_rate.next(force.by_rate, r.depth, 0);
    r.depth[i + 1] = reciprocal.of[i + 1] * r.rate[i];
    r.damped[i + 1] = r.by_rate.next(force.by_rate, r.depth, i + 1);
    return force.ratio * r.damped[i] + (i + 1.0) * r.damped[i + 1];
  }

  /// What the numbers of the law do to it.
  MARIOTTE_SERIES_INLINE void add_law(const Force& force, const ContactColumns<N>& own, int i,
                                      Pack& growth) const {
    if (is_log_) {
      if (force.has_log) growth += 2 * force.all[i] * own.exponent;
      return;
    }
    if (force.has_spring) growth += force.spring[i] * own.stiffness;
    if (force.has_damper) growth += force.damper[i] * own.damping;
    if (own.has_exponent) growth += force.by_exponent[i] * own.exponent;
  }

  MARIOTTE_SERIES_INLINE Pack depth(const Forces& forces, const Columns<N>& columns, const Rows& rows,
                                    std::size_t j, int i) const {
    const auto& own = columns.contact[j];
    Pack sum(0.0);
    if (!is_log_) sum = i == 0 ? own.depth : Pack(forces.time[i] * own.rate);
    if (!is_log_ && own.has_drive) sum += forces.half_square[i] * own.drive;
    for (const auto& effect : columns.on_depth[j])
      effect.add_to(sum, rows[effect.by].travel[i], is_log_ ? 0 : forces.contact[effect.by].travel[i]);
    return sum;
  }

  MARIOTTE_SERIES_INLINE Pack rate(const Forces& forces, const Columns<N>& columns, const Rows& rows,
                                   std::size_t j, int i) const {
    const auto& own = columns.contact[j];
    Pack sum(0.0);
    if (!is_log_) sum = i == 0 ? own.rate : Pack(forces.time[i] * own.drive);
    for (const auto& effect : columns.on_depth[j])
      effect.add_to(sum, rows[effect.by].impulse[i], is_log_ ? 0 : forces.contact[effect.by].impulse[i]);
    return sum;
  }

  bool is_log_ = false;
};

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET
