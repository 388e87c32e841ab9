// Lanes in vector registers. Included by one source file per instruction set, which names the namespace they
// live in; nothing here may call functions that other files share.
#pragma once
#include "mariotte/series/unrolled.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

typedef double Vec __attribute__((vector_size(MARIOTTE_VECTOR_BYTES)));
typedef double Loose __attribute__((vector_size(MARIOTTE_VECTOR_BYTES), aligned(8)));  ///< at any place
typedef long long Mask __attribute__((vector_size(MARIOTTE_VECTOR_BYTES)));
inline constexpr int width = MARIOTTE_VECTOR_BYTES / 8;

MARIOTTE_SERIES_INLINE Vec splat(double a) {
  return a - Vec{};
}
MARIOTTE_SERIES_INLINE Vec least(Vec a, Vec b) {
  return a < b ? a : b;
}
MARIOTTE_SERIES_INLINE Vec largest(Vec a, Vec b) {
  return a > b ? a : b;
}
MARIOTTE_SERIES_INLINE Vec magnitude(Vec a) {
  return largest(a, -a);
}
MARIOTTE_SERIES_INLINE Vec root(Vec a) {
  for (int i = 0; i < width; ++i) a[i] = __builtin_sqrt(a[i]);
  return a;
}
MARIOTTE_SERIES_INLINE Vec to_the(Vec a, Vec power) {
  for (int i = 0; i < width; ++i) a[i] = __builtin_pow(a[i], power[i]);
  return a;
}
MARIOTTE_SERIES_INLINE bool all_of(Mask mask) {
  bool all = true;
  for (int i = 0; i < width; ++i) all = all && mask[i];
  return all;
}
MARIOTTE_SERIES_INLINE bool any_of(Mask mask) {
  long long any = 0;
  for (int i = 0; i < width; ++i) any |= mask[i];
  return any != 0;
}
/// As flow::rough_root: what the exponent and the leading bits say, divided by n.
MARIOTTE_SERIES_INLINE Vec rough_root(Vec a, double n) {
  constexpr long long one = 0x3fef000000000000, exponent = 0x4330000000000000;  // of 2^52
  constexpr int dropped = 12;                                                   // bits that count for nothing
  const Vec offset = splat(0x1p52 + static_cast<double>(one >> dropped));
  const Vec bits = (Vec)(((Mask)a >> dropped) | exponent);
  const Vec root = (bits - offset) * (1 / n) + offset;
  return (Vec)(((Mask)root ^ exponent) << dropped);
}
/// Lower bound of a + b x + c x² + d x³ + … on [0, place]: the Bernstein form of these terms less what the
/// others can take away, `loss` place⁴. What starts at zero is divided by x first.
MARIOTTE_SERIES_INLINE Vec lower_bound(Vec a, Vec b, Vec c, Vec d, Vec loss, Vec place) {
  const Vec square = place * place, second = place * c, third = square * d;
  const Vec b1 = a + place / 3 * b, b2 = b1 + place / 3 * (b + second), b3 = a + place * (b + second + third);
  const Vec from_zero = least(b, least(b + 0.5 * second, b + second + third));
  const Vec least_value = a == Vec{} ? from_zero : least(least(a, b1), least(b2, b3));
  return least_value - (a == Vec{} ? place : square) * square * loss;
}
/// Lanes first, first + 1, … of two registers side by side.
template <int first>
MARIOTTE_SERIES_INLINE Vec window(Vec a, Vec b) {
#ifndef __clang__
  Mask lanes{};
  for (int i = 0; i < width; ++i) lanes[i] = first + i;
  return __builtin_shuffle(a, b, lanes);
#elif MARIOTTE_VECTOR_BYTES == 16
  return __builtin_shufflevector(a, b, first, first + 1);
#elif MARIOTTE_VECTOR_BYTES == 32
  return __builtin_shufflevector(a, b, first, first + 1, first + 2, first + 3);
#else
  return __builtin_shufflevector(a, b, first, first + 1, first + 2, first + 3, first + 4, first + 5,
                                 first + 6, first + 7);
#endif
}
MARIOTTE_SERIES_INLINE double largest_of(Vec a) {
  if constexpr (width > 4) a = largest(a, window<width / 2>(a, a));
  if constexpr (width > 2) a = largest(a, window<2>(a, a));
  return largest(a, window<1>(a, a))[0];
}

/// N registers of lanes.
template <int N>
struct LaneVector {
  static constexpr int parts = N;
  Vec part[N];

  LaneVector() = default;
  MARIOTTE_SERIES_INLINE explicit LaneVector(double a) {
    for (int i = 0; i < N; ++i) part[i] = splat(a);
  }
  // Register by register: left to itself the compiler copies halves, and a load waits for both.
  MARIOTTE_SERIES_INLINE LaneVector(const LaneVector& a) { *this = a; }
  MARIOTTE_SERIES_INLINE LaneVector& operator=(const LaneVector& a) {
    for (int i = 0; i < N; ++i) part[i] = a.part[i];
    return *this;
  }
};

template <int N, class F>
MARIOTTE_SERIES_INLINE LaneVector<N> each(F&& f) {
  LaneVector<N> r;
  if constexpr (N <= 6)
    series::unrolled<N>([&](int i) MARIOTTE_SERIES_LAMBDA { r.part[i] = f(i); });
  else
#pragma GCC unroll 8
    for (int i = 0; i < N; ++i) r.part[i] = f(i);
  return r;
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> load(const double* from) {
  return each<N>([&](int i) { return *reinterpret_cast<const Vec*>(from + width * i); });
}
template <int N>
MARIOTTE_SERIES_INLINE void store(const LaneVector<N>& r, double* to) {
  for (int i = 0; i < N; ++i) *reinterpret_cast<Vec*>(to + width * i) = r.part[i];
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> load_loose(const double* from) {
  return each<N>([&](int i) { return *reinterpret_cast<const Loose*>(from + width * i); });
}
template <int N>
MARIOTTE_SERIES_INLINE void store_loose(const LaneVector<N>& r, double* to) {
  for (int i = 0; i < N; ++i) *reinterpret_cast<Loose*>(to + width * i) = r.part[i];
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> operator+(const LaneVector<N>& a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a.part[i] + b.part[i]; });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> operator-(const LaneVector<N>& a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a.part[i] - b.part[i]; });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> operator*(const LaneVector<N>& a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a.part[i] * b.part[i]; });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> operator/(const LaneVector<N>& a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a.part[i] / b.part[i]; });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> operator-(const LaneVector<N>& a) {
  return each<N>([&](int i) { return -a.part[i]; });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> magnitude(const LaneVector<N>& a) {
  return each<N>([&](int i) { return magnitude(a.part[i]); });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> sqrt(const LaneVector<N>& a) {
  return each<N>([&](int i) { return root(a.part[i]); });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> pow(const LaneVector<N>& a, const LaneVector<N>& exponent) {
  return each<N>([&](int i) { return to_the(a.part[i], exponent.part[i]); });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> operator*(double a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a * b.part[i]; });
}
/// Lane i takes the value of its left neighbour; the first takes 0.
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> from_left(const LaneVector<N>& a) {
  return each<N>([&](int i) { return window<width - 1>(i > 0 ? a.part[i - 1] : Vec{}, a.part[i]); });
}
template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> from_right(const LaneVector<N>& a) {
  return each<N>([&](int i) { return window<1>(a.part[i], i + 1 < N ? a.part[i + 1] : Vec{}); });
}

template <int N>
MARIOTTE_SERIES_INLINE LaneVector<N> from_lane(const LaneVector<N>& a, int lane) {
  return LaneVector<N>(a.part[lane / width][lane % width]);
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
