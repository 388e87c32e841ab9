// Coefficients of all series of a field by order, and the sums over what is known from earlier orders.
#pragma once
#include "mariotte/series/compiler.hpp"
#include "mariotte/series/unrolled.hpp"

namespace mariotte::series {

/// Every series is a row; convolutions of six pairs of rows run side by side, so that nothing waits, and more
/// would not fit into the registers.
template <class Field, int MostOrder, class V>
class Rows {
 public:
  using Row = std::array<V, MostOrder + 2>;
  const Row& operator[](int row) const { return row_[row]; }
  Row& operator[](int row) { return row_[row]; }

  /// Coefficient k of step i.
  template <int i>
  MARIOTTE_SERIES_INLINE void keep(int k, const V& value) {
    constexpr Step step = P.step[i];
    if constexpr (step.op != Op::state && step.row >= 0) row_[step.row][k] = value;
    if constexpr (step.slopes >= 0) row_[step.slopes][k] = double(k) * value;
  }
  /// All coefficients k are known.
  MARIOTTE_SERIES_INLINE void complete(int, const V*) {}

  /// Σ a_j b_{k−j} over 0 < j < k of the first `count` convolutions, from the middle outwards: the newest
  /// coefficients come last. Of a square each term is taken once.
  template <int count, class Order>
  MARIOTTE_SERIES_INLINE void convolve(Order k, V* total) const {
    constexpr int group = 6;
    unrolled<(count + group - 1) / group>([&](auto g) MARIOTTE_SERIES_LAMBDA {
      convolve_some<g * group, (count - g * group < group ? count - g * group : group)>(k, total);
    });
  }

 private:
  static constexpr const Program& P = program<Field>;

  template <int first, int count, class Order>
  MARIOTTE_SERIES_INLINE void convolve_some(Order k, V* total) const {
    V one[count], two[count];
    unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      constexpr int a = P.row(P.convolution[first + i].a), b = P.row(P.convolution[first + i].b);
      one[i] = V(0.0);
      two[i] = V(0.0);
      if (is_even(k)) one[i] = (a == b ? 0.5 : 1.0) * row_[a][k / 2] * row_[b][k / 2];
    });
    for (int j = (k - 1) / 2; j >= 1; --j)
      unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
        constexpr int a = P.row(P.convolution[first + i].a), b = P.row(P.convolution[first + i].b);
        one[i] = one[i] + row_[a][j] * row_[b][k - j];
        if constexpr (a != b) two[i] = two[i] + row_[a][k - j] * row_[b][j];
      });
    unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      constexpr Convolution c = P.convolution[first + i];
      total[first + i] = c.a == c.b ? one[i] + one[i] : one[i] + two[i];
    });
  }

  Row row_[P.rows] = {};
};

/// Of plain numbers two convolutions share a register: their factors are packed by order, in pairs.
template <class Field, int MostOrder>
class Rows<Field, MostOrder, double> {
 public:
  using Row = std::array<double, MostOrder + 2>;
  const Row& operator[](int row) const { return row_[row]; }
  Row& operator[](int row) { return row_[row]; }

  template <int i>
  MARIOTTE_SERIES_INLINE void keep(int k, double value) {
    constexpr Step step = P.step[i];
    if constexpr (step.op != Op::state && step.row >= 0 && step.row < rows_of<Field>)
      row_[step.row][k] = value;
  }
  MARIOTTE_SERIES_INLINE void complete(int k, const double* value) {
    const auto factor = [&](Factor f) MARIOTTE_SERIES_LAMBDA { return (f.slopes ? k : 1) * value[f.step]; };
    unrolled<pairs>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      constexpr Convolution one = P.convolution[2 * i], two = P.convolution[2 * i + 1];
      left_[k][i] = Pair{factor(one.a), factor(two.a)};
      right_[k][i] = Pair{factor(one.b), factor(two.b)};
    });
  }

  template <int count, class Order>
  MARIOTTE_SERIES_INLINE void convolve(Order k, double* total) const {
    constexpr int size = (count + 1) / 2, group = 6;
    unrolled<(size + group - 1) / group>([&](auto g) MARIOTTE_SERIES_LAMBDA {
      convolve_some<g * group, (size - g * group < group ? size - g * group : group)>(k, total);
    });
  }

 private:
  typedef double Pair __attribute__((vector_size(16)));
  static constexpr const Program& P = program<Field>;
  static constexpr int pairs = (P.convolutions + 1) / 2;

  template <int first, int count, class Order>
  MARIOTTE_SERIES_INLINE void convolve_some(Order k, double* total) const {
    Pair sum[count];
    unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      sum[i] = is_even(k) ? left_[k / 2][first + i] * right_[k / 2][first + i] : Pair{};
    });
    for (int j = (k - 1) / 2; j >= 1; --j)
      unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
        sum[i] += left_[j][first + i] * right_[k - j][first + i];
        sum[i] += left_[k - j][first + i] * right_[j][first + i];
      });
    unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      total[2 * (first + i)] = sum[i][0];
      total[2 * (first + i) + 1] = sum[i][1];
    });
  }

  Row row_[rows_of<Field>] = {};
  Pair left_[MostOrder + 1][pairs + 1], right_[MostOrder + 1][pairs + 1];
};

}  // namespace mariotte::series
