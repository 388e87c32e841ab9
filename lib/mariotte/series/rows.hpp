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

/// Every series is a row; up to six sums of products of rows run side by side, so that nothing waits. More
/// would not fit into the registers.
template <class Field, int MostOrder, class V>
class Rows {
 public:
  using Row = std::array<V, MostOrder + 2>;
  /// Room for the sums of all convolutions.
  static constexpr int sums = program<Field>.convolutions + 1;
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

/// So many plain numbers share a register; a field that is compiled for wider ones says so.
template <class Field>
inline constexpr int packed = 2;
template <class Field>
requires requires {
  Field::packed;
}
inline constexpr int packed<Field> = Field::packed;

/// Of plain numbers some convolutions share a register: their factors are packed by order.
template <class Field, int MostOrder>
class Rows<Field, MostOrder, double> {
 public:
  using Row = std::array<double, MostOrder + 2>;
  static constexpr int sums = (program<Field>.convolutions / packed<Field> + 1) * packed<Field>;
  const Row& operator[](int row) const { return row_[row]; }
  Row& operator[](int row) { return row_[row]; }

  template <int i>
  MARIOTTE_SERIES_INLINE void keep(int k, double value) {
    constexpr Step step = P.step[i];
    if constexpr (step.op != Op::state && step.row >= 0 && step.row < rows_of<Field>)
      row_[step.row][k] = value;
  }
  MARIOTTE_SERIES_INLINE void complete(int k, const double* value) {
    unrolled<packs>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      left_[k][i] = factors<i * width, &Convolution::a>(k, value, Lanes());
      right_[k][i] = factors<i * width, &Convolution::b>(k, value, Lanes());
    });
  }

  template <int count>
  MARIOTTE_SERIES_INLINE void convolve(int k, double* total) const {
    constexpr int size = (count + width - 1) / width, groups = (size + 5) / 6;
    unrolled<groups>([&](auto g) MARIOTTE_SERIES_LAMBDA {
      constexpr int first = g * size / groups, next = (g + 1) * size / groups;
      convolve_some<first, next - first>(k, total);
    });
  }

 private:
  static constexpr const Program& P = program<Field>;
  static constexpr int width = packed<Field>, packs = (P.convolutions + width - 1) / width;
  typedef double Pack __attribute__((vector_size(8 * width)));
  using Lanes = std::make_integer_sequence<int, width>;

  /// Of convolutions side by side, at once: to put lanes into a register one by one would wait for memory.
  template <int first, Factor Convolution::*side, int... lane>
  MARIOTTE_SERIES_INLINE static Pack factors(int k, const double* value,
                                             std::integer_sequence<int, lane...>) {
    return Pack{(((P.convolution[first + lane].*side).slopes ? k : 1) *
                 value[(P.convolution[first + lane].*side).step])...};
  }

  template <int first, int count>
  MARIOTTE_SERIES_INLINE void convolve_some(int k, double* total) const {
    Pack one[count], two[count];
    unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
      one[i] = k % 2 == 0 ? left_[k / 2][first + i] * right_[k / 2][first + i] : Pack{};
      two[i] = Pack{};
    });
    for (int j = (k - 1) / 2; j >= 1; --j)
      unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA {
        one[i] += left_[j][first + i] * right_[k - j][first + i];
        two[i] += left_[k - j][first + i] * right_[j][first + i];
      });
    unrolled<count>([&](auto i) MARIOTTE_SERIES_LAMBDA { one[i] += two[i]; });
    unrolled<count * width>([&](auto lane) MARIOTTE_SERIES_LAMBDA {
      constexpr int i = lane;
      total[first * width + i] = one[i / width][i % width];
    });
  }

  Row row_[rows_of<Field>] = {};
  Pack left_[MostOrder + 1][packs + 1], right_[MostOrder + 1][packs + 1];
};

}  // namespace mariotte::series
