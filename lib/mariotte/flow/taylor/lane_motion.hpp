// What the series of some registers of contacts say: how far they go, values and bounds. Included by one
// source file per instruction set, which names the namespace they live in.
#pragma once
#include "mariotte/flow/taylor/row_fields.hpp"
#include "mariotte/flow/taylor/taylor_lanes.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// See Expansion; of the N registers from `first` on.
template <int N>
Outlook activate(Lanes& lanes, int first, double near, bool onsets) {
  constexpr double sudden = 1e13;  // of δ̇/δ: coefficients grow like powers of that
  const Vec counted_below = splat(onsets ? __builtin_inf() : 0);
  Mask lands{}, begins{};
  for (int i = 0; i < N; ++i) {
    const auto at = [&](const double* row) { return *reinterpret_cast<const Vec*>(row + first + width * i); };
    const auto depth = at(lanes.indentation), rate = at(lanes.rate), speed = magnitude(rate);
    const auto acts = depth > at(lanes.acts_above), counts = (rate < counted_below) | (depth == Vec{});
    *reinterpret_cast<Vec*>(lanes.active + first + width * i) = acts ? splat(1) : Vec{};
    lands |= (Mask)(counts & (at(lanes.rooted) > Vec{}) & (depth < near * speed));
    begins |= (Mask)(acts & (at(lanes.power) > Vec{}) & (depth > Vec{}) & (speed > sudden * depth));
  }
  return {any_of(lands), any_of(begins)};
}

/// How contacts move, as polynomials in the clock: those of lanes `first` to first + N × width.
template <int N>
struct LaneMotion : RowQuantities {
  static constexpr int size = N * width;

  const Lanes* lanes = nullptr;
  int first = 0, order = 0;
  bool damped = false, clocked = false;
  bool still = false;  ///< no contact pushes, and no load is watched that has a power of δ
  std::array<LaneVector<N>, parameters> parameter;
  LaneVector<N> mobility;      ///< 1/m*
  LaneVector<N> heard;         ///< l/c of a slack contact whose load is watched, else 0
  LaneVector<N> width_weight;  ///< 1/u
  std::array<LaneVector<N>, order_limit + 2>* coefficient = nullptr;  ///< by quantity and order

  double at(int quantity, int k, int lane) const {
    const int i = lane - first;
    return coefficient[quantity][k].part[i / width][i % width];
  }

  double size_of(int k) const {
    const auto weight = of(lanes->weight);
    Vec most{};
    for (int i = 0; i < N; ++i)
      most = largest(most, largest(magnitude(coefficient[rate][k].part[i]),
                                   weight.part[i] * magnitude(coefficient[indentation][k].part[i])));
    for (int i = 0; damped && i < N; ++i)
      most = largest(most, mobility.part[i] * magnitude(coefficient[work][k].part[i]));
    for (int i = 0; has_stretch() && k < order && i < N; ++i)
      most = largest(most, heard.part[i] * magnitude(coefficient[stretch][k].part[i]));
    for (int i = 0; lanes->widened && !still && i < N; ++i)
      most = largest(most, width_weight.part[i] * magnitude(coefficient[WidthQuantities::width][k].part[i]));
    return largest_of(most);
  }

  void evaluate(double place, Values& values) const {
    const auto side = of(lanes->side);
    const auto &depths = coefficient[indentation], &impulses = coefficient[impulse];
    auto d = depths[order], p = impulses[order], amount = magnitude(d);
    int k = order - 1;
    for (; k >= 4; --k) {
      d = place * d + depths[k];
      p = place * p + impulses[k];
      amount = place * amount + magnitude(depths[k]);
    }
    const auto loss = 0.5 * (amount - side * d);
    for (; k >= 0; --k) {
      d = place * d + depths[k];
      p = place * p + impulses[k];
    }
    store(d, values.indentation + first);
    store(p, values.impulse + first);
    store(bound(depths, side, edges(), loss, place), values.margin + first);
    tell_falls(values);
    tell_depths(values);
    if (damped) evaluate_damped(place, values);
    if (lanes->branched) evaluate_branches(place, values);
    if (lanes->widened && !still) evaluate_widths(place, values);
  }
  double time_at(double place) const {
    if (!clocked) return place;
    double sum = at(time, order, first);
    for (int k = order - 1; k >= 0; --k) sum = sum * place + at(time, k, first);
    return sum;
  }

  void sharpen(double place, Values& values) const {
    constexpr int degree = 9;  // of the terms in Bernstein form; what the others can take away is subtracted
    double factor[degree + 1] = {1};  // placeᵏ/C(degree, k)
    for (int k = 0; k < degree; ++k)
      factor[k + 1] = factor[k] * place * (k + 1) * series::reciprocal.of[degree - k];
    const double beyond = factor[degree] * place;
    const auto side = of(lanes->side), edge = edges();
    const auto by_root = told_by_root(side, edge, of(values.indentation));
    for (int i = 0; i < N; ++i) {
      auto& margin = *reinterpret_cast<Vec*>(values.margin + first + width * i);
      if (!any_of((Mask)(margin < Vec{}))) continue;
      const auto told = by_root.part[i] > Vec{};
      const auto term = [&](int k) {
        return told ? coefficient[root][k].part[i] : side.part[i] * coefficient[indentation][k].part[i];
      };
      Vec loss = largest(-side.part[i] * coefficient[indentation][order].part[i], Vec{}), b[degree + 1];
      loss = told ? Vec{} : loss;  // the root has no coefficient of that order
      for (int k = order - 1; k > degree; --k) loss = place * loss + largest(-term(k), Vec{});
      for (int k = 0; k <= degree; ++k) b[k] = factor[k] * term(k);
      b[0] += told ? Vec{} : edge.part[i];
      for (int from = 1; from <= degree; ++from)  // as in Pascal's triangle
        for (int k = degree; k >= from; --k) b[k] += b[k - 1];
      Vec lowest = b[0];
      for (int k = 1; k <= degree; ++k) lowest = least(lowest, b[k]);
      lowest -= beyond * loss;
      margin = lowest > Vec{} ? lowest : margin;
    }
    tell_falls(values);
  }

  void coefficients(Quantity quantity, int lane, double* c) const {
    switch (quantity) {
      case Quantity::indentation:
        return copy(indentation, lane, c);
      case Quantity::rate:
        return copy(rate, lane, c);
      case Quantity::load:
        for (int k = 0; k <= order; ++k)
          c[k] = load_of(k).part[(lane - first) / width][(lane - first) % width];
        return;
      case Quantity::root:
        copy(root, lane, c);
        c[order] = 0;
        return;
      case Quantity::impulse:
        return copy(impulse, lane, c);
      case Quantity::clock:
        return clocked ? copy(clock, first, c) : set_power(0, c);
      case Quantity::time:
        return clocked ? copy(time, first, c) : set_power(1, c);
    }
  }

  LaneVector<N> of(const double* numbers) const { return load<N>(numbers + first); }
  bool has_stretch() const { return lanes->general && lanes->mixed && !lanes->widened; }
  /// What a term of higher order can take away.
  static LaneVector<N> loss_of(const LaneVector<N>& a) {
    return each<N>([&](int i) { return largest(-a.part[i], Vec{}); });
  }

 private:
  void copy(int quantity, int lane, double* c) const {
    const auto* from = reinterpret_cast<const double*>(&coefficient[quantity]) + (lane - first);
    for (int k = 0; k <= order; ++k) c[k] = from[k * size];
  }
  void set_power(int n, double* c) const {
    for (int k = 0; k <= order; ++k) c[k] = k == n;
  }

  Mask left_out(int i) const { return (Mask)(of(lanes->active).part[i] == Vec{}); }
  /// Levels of indentations within a step.
  LaneVector<N> edges() const {
    const auto edge = of(lanes->level), leeway = of(lanes->leeway);
    if (!lanes->has_leeway()) return edge;
    return each<N>([&](int i) { return edge.part[i] + (left_out(i) ? leeway.part[i] : Vec{}); });
  }
  void tell_falls(Values& values) const {
    const auto margin = of(values.margin), depth = of(values.indentation), edge = of(lanes->level),
               leeway = of(lanes->leeway);
    Mask any{};
    for (int i = 0; i < N; ++i) {
      const auto is_beyond = (leeway.part[i] > Vec{}) & (depth.part[i] < -edge.part[i]);
      any |= (Mask)(margin.part[i] < Vec{}) | (left_out(i) & (Mask)is_beyond);
    }
    values.may_fall = values.may_fall || any_of(any);
  }
  void tell_depths(Values& values) const {
    const auto depth = of(values.indentation), late = of(lanes->late_above),
               least_depth = of(lanes->fades_below), noise = of(lanes->leaves_noise);
    Mask deep{}, change{};
    for (int i = 0; i < N; ++i) {
      const Vec d = depth.part[i];
      deep |= left_out(i) & (Mask)(d > late.part[i]);
      change |= (Mask)((d < least_depth.part[i]) | (magnitude(d) > noise.part[i]));
    }
    values.is_deep = values.is_deep || any_of(deep);
    values.may_change = values.may_change || any_of(change);
  }
  /// 1 where √δ is expanded and tells that δ stays positive, and so above its level: it falls less steeply.
  LaneVector<N> told_by_root(const LaneVector<N>& side, const LaneVector<N>& edge,
                             const LaneVector<N>& end) const {
    if (lanes->widened || still) return LaneVector<N>(0.0);
    return each<N>([&](int i) {
      const auto told = (side.part[i] > Vec{}) & (edge.part[i] >= Vec{}) & (end.part[i] > Vec{});
      return told ? parameter[curved].part[i] : Vec{};
    });
  }

  /// Lower bound of side × polynomial + edge on [0, place]; `loss` is what terms from the fourth power on can
  /// take away, over place⁴.
  static LaneVector<N> bound(const auto& c, const LaneVector<N>& side, const LaneVector<N>& edge,
                             const LaneVector<N>& loss, double place) {
    return each<N>([&](int i) {
      const Vec s = side.part[i];
      const Vec least_value = lower_bound(s * c[0].part[i] + edge.part[i], s * c[1].part[i], s * c[2].part[i],
                                          s * c[3].part[i], loss.part[i], splat(place));
      return s == Vec{} ? s : least_value;
    });
  }

  /// Coefficient k of the loads, but for the last one of l δᵖ δ.
  LaneVector<N> load_of(int k) const {
    const auto& p = parameter;
    const auto viscous = p[stiffness] * coefficient[indentation][k] + p[damping] * coefficient[rate][k];
    if (!lanes->mixed) return viscous;
    const bool stretches = has_stretch() && k < order;
    return each<N>([&](int i) {
      const auto multiplied =
          p[stiffening].part[i] * coefficient[rate][k].part[i] + (k == 0 ? p[stiffness].part[i] : Vec{});
      const auto stretched = stretches ? p[steepening].part[i] * coefficient[stretch][k].part[i] : Vec{};
      return p[stiffening].part[i] > Vec{} ? multiplied : viscous.part[i] + stretched;
    });
  }

  void evaluate_damped(double place, Values& values) const {
    LaneVector<N> loads[order_limit + 1];
    const auto& works = coefficient[work];
    for (int k = 0; k <= order; ++k) loads[k] = load_of(k);
    const auto side = of(lanes->load_side);
    auto w = works[order], loss = loss_of(side * loads[order]);
    for (int k = order - 1; k >= 0; --k) {
      w = place * w + works[k];
      if (k >= 4) loss = place * loss + loss_of(side * loads[k]);
    }
    store(w, values.work + first);
    store(bound(loads, side, LaneVector<N>(0.0), loss, place), values.load_margin + first);
  }

  void evaluate_widths(double place, Values& values) const {
    const auto& widths = coefficient[WidthQuantities::width];
    auto u = widths[order];
    for (int k = order - 1; k >= 0; --k) u = place * u + widths[k];
    store(u, values.width + first);
  }

  void evaluate_branches(double place, Values& values) const {
    const auto &depths = coefficient[indentation], &rates = coefficient[rate];
    const auto below = -of(lanes->yield_side), side = of(lanes->turn_side);
    auto loss = loss_of(below * depths[order]), rate_loss = loss_of(side * rates[order]);
    for (int k = order - 1; k >= 4; --k) {
      loss = place * loss + loss_of(below * depths[k]);
      rate_loss = place * rate_loss + loss_of(side * rates[k]);
    }
    const auto yields = bound(depths, below, of(lanes->yield_level), loss, place),
               turns = bound(rates, side, of(lanes->turn_level), rate_loss, place);
    store(each<N>([&](int i) { return least(yields.part[i], turns.part[i]); }), values.branch_margin + first);
  }
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
