// The recurrences of the Taylor flow. Included by one source file per instruction set, which names the
// namespace they live in; nothing here may call functions that other files share.
//
// With the clock factor g = dt/dσ (1, or √δ_c in the clock of lane c), u the inverse masses, k-th
// coefficients written as indices and products as convolutions:
//   λ = k δ + c δ̇            load
//   s = δᵖ                    p = 1/2: s_k = (δ_k − Σ_{0<j<k} s_j s_{k−j}) / (2 s_0); of lane c, s' = δ̇/2
//                             any p: s_k = Σ_{0<j≤k} (j (p + 1) − k) δ_j s_{k−j} / (k δ_0); s = 1 if p = 0
//   f = s λ                   force
//   δ' = g δ̇
//   δ̇' = g (u_l f_left − (u_l + u_r) f + u_r f_right + drive)
//   p' = g f                  impulse
//   w' = g f δ̇                work
#pragma once
#include "mariotte/flow/taylor/taylor_lanes.hpp"

// Left to itself the compiler keeps rows in memory; sanitizers turn this off, since it makes them crawl.
#ifndef MARIOTTE_INLINE
#define MARIOTTE_INLINE [[gnu::always_inline]]
#endif

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

typedef double Vec __attribute__((vector_size(MARIOTTE_VECTOR_BYTES)));
typedef long long Mask __attribute__((vector_size(MARIOTTE_VECTOR_BYTES)));
inline constexpr int width = MARIOTTE_VECTOR_BYTES / 8;

inline Vec splat(double a) {
  return a - Vec{};
}
inline Vec least(Vec a, Vec b) {
  return a < b ? a : b;
}
inline Vec largest(Vec a, Vec b) {
  return a > b ? a : b;
}
inline Vec magnitude(Vec a) {
  return largest(a, -a);
}
inline Vec root(Vec a) {
  for (int i = 0; i < width; ++i) a[i] = __builtin_sqrt(a[i]);
  return a;
}
inline Vec to_the(Vec a, Vec power) {
  for (int i = 0; i < width; ++i) a[i] = __builtin_pow(a[i], power[i]);
  return a;
}
/// Lanes first, first + 1, … of two registers side by side.
template <int first>
inline Vec window(Vec a, Vec b) {
#ifndef __clang__
  Mask lanes{};
  for (int i = 0; i < width; ++i) lanes[i] = first + i;
  return __builtin_shuffle(a, b, lanes);
#elif MARIOTTE_VECTOR_BYTES == 16
  return __builtin_shufflevector(a, b, first, first + 1);
#else
  return __builtin_shufflevector(a, b, first, first + 1, first + 2, first + 3);
#endif
}

/// N registers of lanes.
template <int N>
struct LaneVector {
  Vec part[N];
};

template <int N, class F>
MARIOTTE_INLINE inline LaneVector<N> each(F&& f) {
  LaneVector<N> r;
#pragma GCC unroll 16
  for (int i = 0; i < N; ++i) r.part[i] = f(i);
  return r;
}
template <int N>
inline LaneVector<N> load(const double* from) {
  return each<N>([&](int i) { return *reinterpret_cast<const Vec*>(from + width * i); });
}
template <int N>
inline void store(const LaneVector<N>& r, double* to) {
  for (int i = 0; i < N; ++i) *reinterpret_cast<Vec*>(to + width * i) = r.part[i];
}
template <int N>
inline LaneVector<N> operator+(const LaneVector<N>& a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a.part[i] + b.part[i]; });
}
template <int N>
inline LaneVector<N> operator-(const LaneVector<N>& a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a.part[i] - b.part[i]; });
}
template <int N>
inline LaneVector<N> operator*(const LaneVector<N>& a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a.part[i] * b.part[i]; });
}
template <int N>
inline LaneVector<N> operator*(double a, const LaneVector<N>& b) {
  return each<N>([&](int i) { return a * b.part[i]; });
}
/// Lane i takes the value of its left neighbour; the first takes 0.
template <int N>
inline LaneVector<N> from_left(const LaneVector<N>& a) {
  return each<N>([&](int i) { return window<width - 1>(i > 0 ? a.part[i - 1] : Vec{}, a.part[i]); });
}
template <int N>
inline LaneVector<N> from_right(const LaneVector<N>& a) {
  return each<N>([&](int i) { return window<1>(a.part[i], i + 1 < N ? a.part[i + 1] : Vec{}); });
}

/// 1/k.
inline constexpr struct Reciprocals {
  double of[order_limit + 2];
  constexpr Reciprocals() : of{} {
    for (int k = 1; k < order_limit + 2; ++k) of[k] = 1.0 / k;
  }
} reciprocal;

template <int N>
class Series final : public Expansion {
 public:
  void expand(const Lanes& lanes, int order, int clock) override {
    order_ = order;
    clock_ = clock;
    damped_ = lanes.damped || lanes.general;
    lanes_ = &lanes;
    begin(lanes);
    if (lanes.general)
      run<Root::any, true>();
    else if (clock == plain)
      damped_ ? run<Root::square, true>() : run<Root::square, false>();
    else
      damped_ ? run<Root::clock, true>() : run<Root::clock, false>();
  }

  void sizes(int first, double* size) const override {
    for (int k = first; k <= order_; ++k) size[k - first] = size_of(k);
  }

  void evaluate(double place, Values& values) const override {
    const auto side = load<N>(lanes_->side);
    auto d = indentation_[order_], p = impulse_[order_], loss = loss_of(side * d);
    for (int k = order_ - 1; k >= 0; --k) {
      d = place * d + indentation_[k];
      p = place * p + impulse_[k];
      if (k >= 4) loss = place * loss + loss_of(side * indentation_[k]);
    }
    store(d, values.indentation);
    store(p, values.impulse);
    const auto margin = bound(indentation_, side, loss, place);
    store(margin + load<N>(lanes_->level), values.margin);
    values.time = clock_ == plain ? place : horner(time_, place);
    if (damped_) evaluate_damped(place, values);
  }

  void sharpen(double place, Values& values) const override {
    constexpr int degree = 9;  // of the terms in Bernstein form; what the others can take away is subtracted
    double factor[degree + 1] = {1};  // placeᵏ/C(degree, k)
    for (int k = 0; k < degree; ++k) factor[k + 1] = factor[k] * place * (k + 1) * reciprocal.of[degree - k];
    const double beyond = factor[degree] * place;
    const auto side = load<N>(lanes_->side), level = load<N>(lanes_->level), margin = load<N>(values.margin);
    store(each<N>([&](int i) {
            Vec loss{}, b[degree + 1];
            for (int k = order_; k > degree; --k)
              loss = place * loss + largest(-side.part[i] * indentation_[k].part[i], Vec{});
            for (int k = 0; k <= degree; ++k) b[k] = factor[k] * side.part[i] * indentation_[k].part[i];
            b[0] += level.part[i];
            for (int row = 1; row <= degree; ++row)  // as in Pascal's triangle
              for (int k = degree; k >= row; --k) b[k] += b[k - 1];
            Vec lowest = b[0];
            for (int k = 1; k <= degree; ++k) lowest = least(lowest, b[k]);
            lowest -= beyond * loss;
            return lowest > Vec{} ? lowest : margin.part[i];
          }),
          values.margin);
  }

  void coefficients(Quantity quantity, int lane, double* c) const override {
    for (int k = 0; k <= order_; ++k) {
      switch (quantity) {
        case Quantity::indentation:
          c[k] = at(indentation_[k], lane);
          break;
        case Quantity::rate:
          c[k] = at(rate_[k], lane);
          break;
        case Quantity::load:
          c[k] = at(stiffness_, lane) * at(indentation_[k], lane) + at(damping_, lane) * at(rate_[k], lane);
          break;
        case Quantity::root:
          c[k] = k < order_ ? at(root_[k], lane) : 0;
          break;
        case Quantity::clock:
          c[k] = clock_ == plain ? k == 0 : stretch_[k];
          break;
        case Quantity::time:
          c[k] = clock_ == plain ? k == 1 : time_[k];
      }
    }
  }

 private:
  enum class Root { square, clock, any };

  double size_of(int k) const {
    const auto weight = load<N>(lanes_->weight);
    Vec most{};
    for (int i = 0; i < N; ++i)
      most = largest(
          most, largest(magnitude(rate_[k].part[i]), weight.part[i] * magnitude(indentation_[k].part[i])));
    for (int i = 0; damped_ && i < N; ++i)
      most = largest(most, mobility_.part[i] * magnitude(work_[k].part[i]));
    double size = most[0];
    for (int i = 1; i < width; ++i) size = most[i] > size ? most[i] : size;
    return size;
  }

  static double at(const LaneVector<N>& row, int lane) { return row.part[lane / width][lane % width]; }
  static LaneVector<N> splat_row(double a) {
    return each<N>([&](int) { return splat(a); });
  }
  /// What a term of higher order can take away.
  static LaneVector<N> loss_of(const LaneVector<N>& a) {
    return each<N>([&](int i) { return largest(-a.part[i], Vec{}); });
  }
  double horner(const double* c, double place) const {
    double sum = c[order_];
    for (int k = order_ - 1; k >= 0; --k) sum = sum * place + c[k];
    return sum;
  }

  void begin(const Lanes& lanes) {
    stiffness_ = load<N>(lanes.stiffness);
    damping_ = load<N>(lanes.damping);
    indentation_[0] = load<N>(lanes.indentation);
    rate_[0] = load<N>(lanes.rate);
    impulse_[0] = work_[0] = LaneVector<N>{};
    drive_ = load<N>(lanes.drive);
    const auto push = load<N>(lanes.active), left = load<N>(lanes.left), right = load<N>(lanes.right);
    strength_ = damped_ ? push : push * stiffness_;
    from_left_ = left * from_left(strength_);
    from_right_ = right * from_right(strength_);
    mobility_ = left + right;
    own_ = mobility_ * strength_;
    power_ = load<N>(lanes.power);
    for (int i = 0; i < N; ++i) {
      const Vec depth = largest(indentation_[0].part[i], Vec{});
      const auto curved = power_.part[i] * push.part[i] != Vec{};
      const Vec s = lanes.general ? to_the(depth, power_.part[i]) : root(depth);
      root_[0].part[i] = curved ? s : splat(1);
      half_inverse_.part[i] = (curved & (s != Vec{})) ? 0.5 / s : Vec{};
      inverse_.part[i] = (curved & (depth != Vec{})) ? 1 / depth : Vec{};
    }
    if (clock_ != plain) {
      chosen_ = LaneVector<N>{};
      chosen_.part[clock_ / width][clock_ % width] = 1;
      stretch_[0] = at(root_[0], clock_);
      time_[0] = 0;
    }
  }

  /// s_k of every lane.
  template <Root Kind>
  MARIOTTE_INLINE LaneVector<N> next_root(int k) const {
    if constexpr (Kind == Root::any) {
      LaneVector<N> sum{};
      for (int j = 1; j <= k; ++j)
        sum = sum + (double(j) * power_ + splat_row(j - k)) * indentation_[j] * root_[k - j];
      return reciprocal.of[k] * (sum * inverse_);
    }
    LaneVector<N> sum{};
    for (int j = (k - 1) / 2; j >= 1; --j) sum = sum + root_[j] * root_[k - j];
    sum = sum + sum;
    if (k % 2 == 0) sum = sum + root_[k / 2] * root_[k / 2];
    auto s = (indentation_[k] - sum) * half_inverse_;
    if constexpr (Kind == Root::clock)
      for (int i = 0; i < N; ++i) s.part[i] = chosen_.part[i] != Vec{} ? splat(stretch_[k]) : s.part[i];
    return s;
  }

  /// Σ a_j b_{k−j}; the newest coefficients, on which the next stage waits, come last.
  MARIOTTE_INLINE static LaneVector<N> product(const LaneVector<N>* a, const LaneVector<N>* b, int k) {
    if (k == 0) return a[0] * b[0];
    LaneVector<N> even{}, odd{};
    for (int j = 1; j + 1 < k; j += 2) {
      even = even + a[j] * b[k - j];
      odd = odd + a[j + 1] * b[k - j - 1];
    }
    if (k % 2 == 0) even = even + a[k - 1] * b[1];
    return (even + odd) + a[k] * b[0] + a[0] * b[k];
  }
  MARIOTTE_INLINE static LaneVector<N> stretched(const double* g, const LaneVector<N>* b, int k) {
    LaneVector<N> sum{};
    for (int j = 0; j <= k; ++j) sum = sum + g[k - j] * b[j];
    return sum;
  }

  template <Root Kind, bool Damped>
  MARIOTTE_INLINE void stage(int k) {
    constexpr bool Clock = Kind == Root::clock;
    if (k > 0) root_[k] = next_root<Kind>(k);
    if constexpr (Damped) load_[k] = stiffness_ * indentation_[k] + damping_ * rate_[k];
    force_[k] = product(root_, Damped ? load_ : indentation_, k);
    const double step = reciprocal.of[k + 1];
    auto force = force_[k], drift = rate_[k];
    if constexpr (Clock) {
      force = stretched(stretch_, force_, k);
      drift = stretched(stretch_, rate_, k);
      time_[k + 1] = step * stretch_[k];
    }
    if constexpr (Damped) {
      stretched_[k] = force;
      work_[k + 1] = step * (strength_ * product(stretched_, rate_, k));
    }
    const double outside = Clock ? stretch_[k] : k == 0;
    const auto pull = outside * drive_ - own_ * force;
    rate_[k + 1] = step * (from_left_ * from_left(force) + (from_right_ * from_right(force) + pull));
    indentation_[k + 1] = step * drift;
    impulse_[k + 1] = step * (strength_ * force);
    if constexpr (Clock) stretch_[k + 1] = 0.5 * step * at(rate_[k], clock_);
  }

  template <Root Kind, bool Damped>
  void run() {
    for (int k = 0; k < order_; ++k) stage<Kind, Damped>(k);
  }

  /// Lower bound of side × polynomial on [0, place]: the Bernstein form of its first four terms less what the
  /// others can take away, `loss` place⁴. A polynomial that starts at zero is divided by σ first.
  static LaneVector<N> bound(const LaneVector<N>* c, const LaneVector<N>& side, const LaneVector<N>& loss,
                             double place) {
    const double square = place * place;
    return each<N>([&](int i) {
      const Vec s = side.part[i], a = s * c[0].part[i], b = s * c[1].part[i], d = place * s * c[2].part[i],
                e = square * s * c[3].part[i];
      const Vec b1 = a + place / 3 * b, b2 = b1 + place / 3 * (b + d), b3 = a + place * (b + d + e);
      const Vec from_zero = least(b, least(b + 0.5 * d, b + d + e));
      const Vec least_value = a == Vec{} ? from_zero : least(least(a, b1), least(b2, b3));
      const Vec beyond = (a == Vec{} ? splat(place) : splat(square)) * square * loss.part[i];
      return s == Vec{} ? s : least_value - beyond;
    });
  }

  void evaluate_damped(double place, Values& values) const {
    LaneVector<N> loads[order_limit + 1];
    for (int k = 0; k <= order_; ++k) loads[k] = stiffness_ * indentation_[k] + damping_ * rate_[k];
    const auto side = load<N>(lanes_->load_side);
    auto w = work_[order_], loss = loss_of(side * loads[order_]);
    for (int k = order_ - 1; k >= 0; --k) {
      w = place * w + work_[k];
      if (k >= 4) loss = place * loss + loss_of(side * loads[k]);
    }
    store(w, values.work);
    store(bound(loads, side, loss, place), values.load_margin);
  }

  using Coefficients = LaneVector<N>[order_limit + 1];
  const Lanes* lanes_ = nullptr;
  int order_ = 0, clock_ = plain;
  bool damped_ = false;
  LaneVector<N> stiffness_, damping_, drive_, power_, half_inverse_, inverse_, chosen_;
  LaneVector<N> mobility_;  ///< 1/m*
  LaneVector<N> strength_, from_left_, from_right_,
      own_;  ///< couplings of the forces; without damping k is in them
  Coefficients indentation_, rate_, root_, load_, force_, stretched_, impulse_, work_;
  double stretch_[order_limit + 1], time_[order_limit + 1];  ///< √δ_c, and t
};

/// The series of lane_sizes[size] lanes.
template <std::size_t Size = 0>
inline std::unique_ptr<Expansion> make(std::size_t size) {
  if constexpr (Size + 1 < lane_sizes.size())
    if (size != Size) return make<Size + 1>(size);
  return std::unique_ptr<Expansion>(new Series<lane_sizes[Size] / width>);
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
