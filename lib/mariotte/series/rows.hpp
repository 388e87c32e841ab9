// Coefficients of all series of a field by order, and the sums over what is known from earlier orders.
#pragma once
#include "mariotte/series/compiler.hpp"
#include "mariotte/series/unrolled.hpp"

namespace mariotte::series {

/// A number may be made of parts, one for each register.
template <class V>
inline constexpr int parts_of = 1;
template <class V>
requires requires {
  V::parts;
}
inline constexpr int parts_of<V> = V::parts;

template <class V>
MARIOTTE_SERIES_INLINE auto& part_of(V& a, int i) {
  if constexpr (requires { a.parts; })
    return a.part[i];
  else
    return a;
}

/// Every series is a row; six sums of products of rows run side by side, so that nothing waits. More would
/// not fit into the registers.
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
  template <int count>
  MARIOTTE_SERIES_INLINE void convolve(int k, V* total) const {
    if constexpr (parts <= group) {
      unrolled<(count + side - 1) / side>([&](auto g) MARIOTTE_SERIES_LAMBDA {
        convolve_some<g * side, (count - g * side < side ? count - g * side : side), parts>(k, 0, total);
      });
    } else {
      for (int part = 0; part < parts; part += block)
        unrolled<count>([&](auto c) MARIOTTE_SERIES_LAMBDA { convolve_some<c, 1, block>(k, part, total); });
    }
  }

 private:
  static constexpr const Program& P = program<Field>;
  static constexpr int parts = parts_of<V>, group = 6, side = parts > group ? 1 : group / parts, block = 4;
  static_assert(parts <= group || parts % block == 0);
  using Part = std::remove_cvref_t<decltype(part_of(std::declval<V&>(), 0))>;

  /// Convolutions from `first` on, of `width` parts from `part` on.
  template <int first, int count, int width>
  MARIOTTE_SERIES_INLINE void convolve_some(int k, int part, V* total) const {
    Part one[count * width], two[count * width];
    const auto each = [&](auto&& visit) MARIOTTE_SERIES_LAMBDA {
      unrolled<count * width>([&](auto i) MARIOTTE_SERIES_LAMBDA {
        constexpr Convolution c = P.convolution[first + i / width];
        constexpr int a = P.row(c.a), b = P.row(c.b);
        const int q = part + i % width;
        visit(
            i, std::integral_constant<bool, a == b>(),
            [&](int j) MARIOTTE_SERIES_LAMBDA { return part_of(row_[a][j], is_uniform<Field>(a) ? 0 : q); },
            [&](int j) MARIOTTE_SERIES_LAMBDA { return part_of(row_[b][j], is_uniform<Field>(b) ? 0 : q); });
      });
    };
    each([&](int i, bool square, auto&& a, auto&& b) MARIOTTE_SERIES_LAMBDA {
      one[i] = k % 2 == 0 ? a(k / 2) * b(k / 2) : Part{};
      if (square) one[i] = 0.5 * one[i];
      two[i] = Part{};
    });
    for (int j = (k - 1) / 2; j >= 1; --j)
      each([&](int i, auto square, auto&& a, auto&& b) MARIOTTE_SERIES_LAMBDA {
        one[i] = one[i] + a(j) * b(k - j);
        if constexpr (!square) two[i] = two[i] + a(k - j) * b(j);
      });
    each([&](int i, bool square, auto&&, auto&&) MARIOTTE_SERIES_LAMBDA {
      part_of(total[first + i / width], part + i % width) = square ? one[i] + one[i] : one[i] + two[i];
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

  template <int count>
  MARIOTTE_SERIES_INLINE void convolve(int k, double* total) const {
    constexpr int size = (count + 1) / 2, group = 6;
    unrolled<(size + group - 1) / group>([&](auto g) MARIOTTE_SERIES_LAMBDA {
      convolve_some<g * group, (size - g * group < group ? size - g * group : group)>(k, total);
    });
  }

 private:
  typedef double Pair __attribute__((vector_size(16)));
  static constexpr const Program& P = program<Field>;
  static constexpr int pairs = (P.convolutions + 1) / 2;

  template <int first, int count>
  MARIOTTE_SERIES_INLINE void convolve_some(int k, double* total) const {
    Pair sum[count];
    unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      sum[i] = k % 2 == 0 ? left_[k / 2][first + i] * right_[k / 2][first + i] : Pair{};
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
