// Taylor coefficients of the solution of a field, by the recurrences of its operations [Moore 1966]:
//
//   x' = r              (k+1) x_{k+1} = r_k
//   c = a b             c_k = Σ a_j b_{k−j}
//   c = a / b           b_0 c_k = a_k − Σ_{j>0} b_j c_{k−j}
//   c = √a              2 c_0 c_k = a_k − Σ_{0<j<k} c_j c_{k−j}
//   c = aⁿ              a_0 c_k = n a_k c_0 + Σ_{0<j<k} (j (n+1)/k − 1) a_j c_{k−j}
//   c = eᵃ              c_k = Σ_{j>0} (j/k) a_j c_{k−j}
//   s, c = sin a, cos a s_k = Σ_{j>0} (j/k) a_j c_{k−j}, c_k = −Σ_{j>0} (j/k) a_j s_{k−j}
//
// The sums over what is known from earlier orders (0 < j < k) run first, several side by side, so that
// nothing waits; the newest coefficients enter last. Orders are a loop: unrolled, they would not fit into the
// caches of instructions. Everything else is unrolled from the program of the field.
#pragma once
#include <cmath>
#include <type_traits>

#include "mariotte/series/rows.hpp"

namespace mariotte::series {

/// Fields that map nothing.
struct NoMaps {};

/// Coefficients of all rows of a field, up to the order MostOrder. V is a number with + − × ÷ and sqrt, made
/// of a double: a double, lanes of registers, a value with slopes. `maps.apply<which>(V)` gives the linear
/// maps that the field asks for.
template <class Field, int MostOrder, class V, class Maps = NoMaps>
class Series {
 public:
  using Row = typename Rows<Field, MostOrder, V>::Row;

  /// Coefficients 0 … order of states and values, for a start and parameters; order ≥ 1. Those up to the
  /// order `known` are here from the call before, which had the same start.
  void expand(const States<Field, V>& start, const Parameters<Field, V>& parameters, int order,
              int known = 0) {
    expand_states(start, parameters, order, known);
    finish(order);
  }
  /// The same without coefficient `order` of values.
  void expand_states(const States<Field, V>& start, const Parameters<Field, V>& parameters, int order,
                     int known = 0) {
    if (known == 0) begin(start, parameters);
    const int first = known == 0 ? 1 : known;
    States<Field, V> newest = coefficients(first);
    for (int k = first; k < order; ++k) stage(k, stay_in_registers ? &newest : nullptr);
  }

  /// Order 0, and order 1 of the states.
  MARIOTTE_SERIES_INLINE void begin(const States<Field, V>& start, const Parameters<Field, V>& parameters) {
    unrolled<P.fixed_values>([&](auto i) MARIOTTE_SERIES_LAMBDA { fixed_[i] = fixed_value<i>(parameters); });
    unrolled<P.steps>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      if constexpr (P.step[i].op == Op::state)
        start_[i] = start[P.step[i].a];
      else
        start_[i] = start_of<i>();
      if constexpr (P.step[i].row >= 0 && P.step[i].row < rows_of<Field>) row_[P.step[i].row][0] = start_[i];
    });
    unrolled<states_of<Field>>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      if constexpr (P.rate[i].step < 0) row_[i][1] = factor<P.rate[i]>();
    });
    unrolled<rows_of<Field> - states_of<Field>>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      constexpr int at = states_of<Field> + i;
      if constexpr (P.value[at].step < 0) row_[at][0] = factor<P.value[at]>();
    });
    integrate(0, start_);
  }

  /// int k of all that is no state, and order k + 1 of the states; k ≥ 1, all orders below are known.
  MARIOTTE_SERIES_INLINE void stage(int k) { stage(k, nullptr); }

  /// int k of values, no more.
  MARIOTTE_SERIES_INLINE void finish(int k) {
    V total[Rows<Field, MostOrder, V>::sums], value[P.steps];
    row_.template convolve<P.seen_convolutions>(k, total);
    unrolled<P.steps>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      if constexpr (P.step[i].seen || P.step[i].op == Op::state) value[i] = coefficient<i>(k, total, value);
    });
    unrolled<rows_of<Field> - states_of<Field>>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      constexpr int at = states_of<Field> + i;
      if constexpr (P.value[at].step >= 0) row_[at][k] = value[P.value[at].step];
    });
  }

  /// Coefficients of a row of the field by order.
  const Row& operator[](int row) const { return row_[row]; }
  Row& operator[](int row) { return row_[row]; }

  [[no_unique_address]] Maps maps = {};

 private:
  static constexpr const Program& P = program<Field>;
  /// So few that nothing has to wait until memory gives back what it was just given.
  static constexpr bool stay_in_registers = states_of<Field> * parts_of<V> <= 4;

  /// Of the states.
  MARIOTTE_SERIES_INLINE States<Field, V> coefficients(int k) const {
    States<Field, V> c;
    unrolled<states_of<Field>>([&](auto i) MARIOTTE_SERIES_LAMBDA { c[i] = row_[i][k]; });
    return c;
  }

  /// Coefficients k of the states are `newest`, if given, which become those k + 1.
  MARIOTTE_SERIES_INLINE void stage(int k, States<Field, V>* newest) {
    V total[Rows<Field, MostOrder, V>::sums], value[P.steps];
    row_.template convolve<P.convolutions>(k, total);
    unrolled<P.steps>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      if constexpr (P.step[i].op == Op::state)
        value[i] = newest ? (*newest)[P.step[i].a] : row_[P.step[i].row][k];
      else
        value[i] = coefficient<i>(k, total, value);
      row_.template keep<i>(k, value[i]);
    });
    row_.complete(k, value);
    integrate(k, value);
    if (newest) *newest = coefficients(k + 1);
  }

  template <int i>
  MARIOTTE_SERIES_INLINE V fixed_value(const Parameters<Field, V>& parameters) const {
    constexpr Node node = P.fixed[i];
    using std::sqrt, std::exp, std::pow, std::sin, std::cos;
    if constexpr (node.op == Op::parameter) return parameters[node.a];
    if constexpr (node.op == Op::number) return V(node.number);
    if constexpr (node.op == Op::sum) return fixed_[node.a] + fixed_[node.b];
    if constexpr (node.op == Op::product) return fixed_[node.a] * fixed_[node.b];
    if constexpr (node.op == Op::quotient) return fixed_[node.a] / fixed_[node.b];
    if constexpr (node.op == Op::root) return sqrt(fixed_[node.a]);
    if constexpr (node.op == Op::power) return pow(fixed_[node.a], fixed_[node.b]);
    if constexpr (node.op == Op::exponential) return exp(fixed_[node.a]);
    if constexpr (node.op == Op::sine) return sin(fixed_[node.a]);
    if constexpr (node.op == Op::cosine) return cos(fixed_[node.a]);
  }

  /// Value of a step at order 0, and what its later orders divide by.
  template <int i>
  MARIOTTE_SERIES_INLINE V start_of() {
    constexpr Step S = P.step[i];
    using std::sqrt, std::exp, std::pow, std::sin, std::cos;
    if constexpr (S.op == Op::sum) {
      const V total = sum<i>(start_);
      if constexpr (S.fixed < 0)
        return total;
      else
        return total + fixed_[S.fixed];
    } else if constexpr (S.op == Op::product) {
      return start_[S.a] * start_[S.b];
    } else if constexpr (S.op == Op::quotient) {
      divisor_[i] = V(1.0) / start_[S.b];
      return numerator<i>(start_) * divisor_[i];
    } else if constexpr (S.op == Op::root) {
      const V root = sqrt(start_[S.a]);
      divisor_[i] = V(0.5) / root;
      return root;
    } else if constexpr (S.op == Op::power) {
      divisor_[i] = V(1.0) / start_[S.a];
      return pow(start_[S.a], fixed_[S.fixed]);
    } else if constexpr (S.op == Op::exponential) {
      return exp(start_[S.a]);
    } else if constexpr (S.op == Op::sine) {
      return sin(start_[S.a]);
    } else if constexpr (S.op == Op::cosine) {
      return cos(start_[S.a]);
    } else {
      return maps.template apply<S.b>(start_[S.a]);
    }
  }
  template <int i>
  MARIOTTE_SERIES_INLINE V numerator(const V* value) const {
    if constexpr (P.step[i].a < 0)
      return fixed_[P.step[i].fixed];
    else
      return value[P.step[i].a];
  }

  /// int k of step i, from the sums over older coefficients.
  template <int i>
  MARIOTTE_SERIES_INLINE V coefficient(int k, const V* total, const V* value) const {
    constexpr Step S = P.step[i];
    if constexpr (S.op == Op::state)
      return row_[S.row][k];
    else if constexpr (S.op == Op::sum)
      return sum<i>(value);
    else if constexpr (S.op == Op::map)
      return maps.template apply<S.b>(value[S.a]);
    else
      return convolved<i>(k, total[S.sum], total, value);
  }

  template <int i>
  MARIOTTE_SERIES_INLINE V convolved(int k, const V& known, const V* total, const V* value) const {
    constexpr Step S = P.step[i];
    if constexpr (S.op == Op::product) return newest<i>(known, value);
    if constexpr (S.op == Op::quotient) return divided<i>(known, value);
    if constexpr (S.op == Op::root) return (value[S.a] - known) * divisor_[i];
    if constexpr (S.op == Op::exponential) return reciprocal.of[k] * known + value[S.a] * start_[i];
    if constexpr (S.op == Op::sine) return reciprocal.of[k] * known + value[S.a] * start_[S.b];
    if constexpr (S.op == Op::cosine) return -(reciprocal.of[k] * known) - value[S.a] * start_[S.b];
    if constexpr (S.op == Op::power) {
      const V n = fixed_[S.fixed];
      return ((n + V(1.0)) * (reciprocal.of[k] * known) - total[S.other_sum] + (n * start_[i]) * value[S.a]) *
             divisor_[i];
    }
  }

  /// What is known last enters last.
  template <int i>
  MARIOTTE_SERIES_INLINE V newest(const V& known, const V* value) const {
    constexpr Step S = P.step[i];
    if constexpr (S.a == S.b)
      return known + (start_[S.a] + start_[S.a]) * value[S.a];
    else if constexpr (P.step[S.a].depth > P.step[S.b].depth)
      return (known + start_[S.a] * value[S.b]) + value[S.a] * start_[S.b];
    else
      return (known + value[S.a] * start_[S.b]) + start_[S.a] * value[S.b];
  }
  template <int i>
  MARIOTTE_SERIES_INLINE V divided(const V& known, const V* value) const {
    constexpr Step S = P.step[i];
    if constexpr (S.a < 0)
      return -((known + value[S.b] * start_[i]) * divisor_[i]);
    else if constexpr (P.step[S.a].depth > P.step[S.b].depth)
      return (value[S.a] - (known + value[S.b] * start_[i])) * divisor_[i];
    else
      return ((value[S.a] - known) - value[S.b] * start_[i]) * divisor_[i];
  }

  template <Term term>
  MARIOTTE_SERIES_INLINE V factor() const {
    if constexpr (term.fixed < 0)
      return V(term.number);
    else
      return fixed_[term.fixed];
  }
  template <Term term>
  MARIOTTE_SERIES_INLINE V weighted(const V& a) const {
    if constexpr (term.fixed >= 0)
      return fixed_[term.fixed] * a;
    else if constexpr (term.number == 1)
      return a;
    else if constexpr (term.number == -1)
      return -a;
    else
      return term.number * a;
  }
  template <int i>
  MARIOTTE_SERIES_INLINE V sum(const V* value) const {
    constexpr int first = P.step[i].first;
    V total = weighted<P.term[first]>(value[P.term[first].step]);
    unrolled<P.step[i].count - 1>([&](auto j) MARIOTTE_SERIES_LAMBDA {
      constexpr Term term = P.term[first + 1 + j];
      if constexpr (term.fixed < 0 && term.number == -1)
        total = total - value[term.step];
      else
        total = total + weighted<term>(value[term.step]);
    });
    return total;
  }

  /// A rate that is constant has been taken by `begin` already.
  MARIOTTE_SERIES_INLINE void integrate(int k, const V* value) {
    const double share = reciprocal.of[k + 1];
    unrolled<states_of<Field>>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      constexpr Term rate = P.rate[i];
      if constexpr (rate.step >= 0 && rate.fixed < 0)
        row_[i][k + 1] = (rate.number * share) * value[rate.step];
      else if constexpr (rate.step >= 0)
        row_[i][k + 1] = (share * fixed_[rate.fixed]) * value[rate.step];
    });
  }

  Rows<Field, MostOrder, V> row_;
  V fixed_[P.fixed_values + 1], start_[P.steps], divisor_[P.steps];
};

}  // namespace mariotte::series
