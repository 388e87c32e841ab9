// Series of a row of contacts in lanes, their evaluation and bounds. Included by one source file per
// instruction set, which names the namespace they live in.
#pragma once
#include "mariotte/flow/taylor/row_fields.hpp"
#include "mariotte/flow/taylor/taylor_lanes.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// What the fields of a row ask for.
struct RowMaps {
  int lane = 0;
  template <int which, int N>
  MARIOTTE_SERIES_INLINE LaneVector<N> apply(const LaneVector<N>& a) const {
    if constexpr (which == 0) return from_left(a);
    if constexpr (which == 1) return from_right(a);
    if constexpr (which == 2) return from_lane(a, lane);
  }
};

template <int N>
class RowSeries final : public Expansion, RowQuantities {
 public:
  void expand(const Lanes& lanes, int order, int lane) override {
    order_ = order;
    clock_ = lane;
    damped_ = lanes.damped || lanes.general;
    lanes_ = &lanes;
    begin(lanes);
    if (lanes.general)
      run(general_, lane);
    else if (lane == plain)
      damped_ ? run(damped_plain_, lane) : run(plain_, lane);
    else
      damped_ ? run(damped_landing_, lane) : run(landing_, lane);
  }

  void sizes(int first, double* size) const override {
    for (int k = first; k <= order_; ++k) size[k - first] = size_of(k);
  }

  void evaluate(double place, Values& values) const override {
    const auto side = load<N>(lanes_->side);
    const auto &depths = row_[indentation], &impulses = row_[impulse];
    auto d = depths[order_], p = impulses[order_], loss = loss_of(side * d);
    for (int k = order_ - 1; k >= 0; --k) {
      d = place * d + depths[k];
      p = place * p + impulses[k];
      if (k >= 4) loss = place * loss + loss_of(side * depths[k]);
    }
    store(d, values.indentation);
    store(p, values.impulse);
    const auto margin = bound(depths, side, loss, place);
    store(margin + load<N>(lanes_->level), values.margin);
    values.time = clock_ == plain ? place : time_at(place);
    if (damped_) evaluate_damped(place, values);
  }

  void sharpen(double place, Values& values) const override {
    constexpr int degree = 9;  // of the terms in Bernstein form; what the others can take away is subtracted
    double factor[degree + 1] = {1};  // placeᵏ/C(degree, k)
    for (int k = 0; k < degree; ++k)
      factor[k + 1] = factor[k] * place * (k + 1) * series::reciprocal.of[degree - k];
    const double beyond = factor[degree] * place;
    const auto side = load<N>(lanes_->side), edge = load<N>(lanes_->level), margin = load<N>(values.margin);
    store(each<N>([&](int i) {
            Vec loss{}, b[degree + 1];
            for (int k = order_; k > degree; --k)
              loss = place * loss + largest(-side.part[i] * row_[indentation][k].part[i], Vec{});
            for (int k = 0; k <= degree; ++k) b[k] = factor[k] * side.part[i] * row_[indentation][k].part[i];
            b[0] += edge.part[i];
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
          c[k] = at(indentation, k, lane);
          break;
        case Quantity::rate:
          c[k] = at(rate, k, lane);
          break;
        case Quantity::load:
          c[k] =
              lanes_->stiffness[lane] * at(indentation, k, lane) + lanes_->damping[lane] * at(rate, k, lane);
          break;
        case Quantity::root:
          c[k] = k < order_ ? at(root, k, lane) : 0;
          break;
        case Quantity::clock:
          c[k] = clock_ == plain ? k == 0 : at(RowQuantities::clock, k, 0);
          break;
        case Quantity::time:
          c[k] = clock_ == plain ? k == 1 : at(time, k, 0);
      }
    }
  }

 private:
  double size_of(int k) const {
    const auto weight = load<N>(lanes_->weight);
    Vec most{};
    for (int i = 0; i < N; ++i)
      most = largest(most, largest(magnitude(row_[rate][k].part[i]),
                                   weight.part[i] * magnitude(row_[indentation][k].part[i])));
    for (int i = 0; damped_ && i < N; ++i)
      most = largest(most, mobility_.part[i] * magnitude(row_[work][k].part[i]));
    double size = most[0];
    for (int i = 1; i < width; ++i) size = most[i] > size ? most[i] : size;
    return size;
  }

  double at(int row, int k, int lane) const { return row_[row][k].part[lane / width][lane % width]; }
  /// What a term of higher order can take away.
  static LaneVector<N> loss_of(const LaneVector<N>& a) {
    return each<N>([&](int i) { return largest(-a.part[i], Vec{}); });
  }
  double time_at(double place) const {
    double sum = at(time, order_, 0);
    for (int k = order_ - 1; k >= 0; --k) sum = sum * place + at(time, k, 0);
    return sum;
  }

  void begin(const Lanes& lanes) {
    auto& p = parameters_;
    start_[indentation] = load<N>(lanes.indentation);
    start_[rate] = load<N>(lanes.rate);
    p[stiffness] = load<N>(lanes.stiffness);
    p[damping] = load<N>(lanes.damping);
    p[power] = load<N>(lanes.power);
    p[drive] = load<N>(lanes.drive);
    divide(lanes);
    const auto left = load<N>(lanes.left), right = load<N>(lanes.right);
    if (!damped_) p[strength] = p[strength] * p[stiffness];
    p[from_left] = left * taylor::MARIOTTE_INSTRUCTION_SET::from_left(p[strength]);
    p[from_right] = right * taylor::MARIOTTE_INSTRUCTION_SET::from_right(p[strength]);
    mobility_ = left + right;
    p[own] = mobility_ * p[strength];
    if (clock_ != plain) start_[RowQuantities::clock] = from_lane(sqrt(start_[indentation]), clock_);
  }

  /// Which contacts push, and which of them have a curved force. One at zero depth has none yet, unless it
  /// owns the clock.
  void divide(const Lanes& lanes) {
    auto& p = parameters_;
    const auto push = load<N>(lanes.active);
    p[chosen] = LaneVector<N>(0.0);
    if (clock_ != plain) p[chosen].part[clock_ / width][clock_ % width] = 1;
    p[free] = LaneVector<N>(1.0) - p[chosen];
    for (int i = 0; i < N; ++i) {
      const auto sharp = p[power].part[i] * push.part[i] != Vec{};
      const auto deep = start_[indentation].part[i] > Vec{}, owner = p[chosen].part[i] != Vec{};
      p[curved].part[i] = sharp & deep & ~owner ? splat(1) : Vec{};
      p[level].part[i] = splat(1) - p[curved].part[i];
      p[strength].part[i] = sharp & ~deep & ~owner ? Vec{} : push.part[i];
    }
  }

  template <class Field>
  using Own = series::Series<Field, order_limit, LaneVector<N>, RowMaps>;
  template <class Field>
  void run(std::unique_ptr<Own<Field>>& series, int lane) {
    if (!series) series = std::make_unique<Own<Field>>();
    series->maps.lane = lane;
    series->expand_states(start_, parameters_, order_);
    row_ = &(*series)[0];
  }

  /// Lower bound of side × polynomial on [0, place]: the Bernstein form of its first four terms less what the
  /// others can take away, `loss` place⁴. A polynomial that starts at zero is divided by σ first.
  static LaneVector<N> bound(const auto& c, const LaneVector<N>& side, const LaneVector<N>& loss,
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
    const auto &depths = row_[indentation], &rates = row_[rate], &works = row_[work];
    const auto spring = parameters_[stiffness], damper = parameters_[damping];
    for (int k = 0; k <= order_; ++k) loads[k] = spring * depths[k] + damper * rates[k];
    const auto side = load<N>(lanes_->load_side);
    auto w = works[order_], loss = loss_of(side * loads[order_]);
    for (int k = order_ - 1; k >= 0; --k) {
      w = place * w + works[k];
      if (k >= 4) loss = place * loss + loss_of(side * loads[k]);
    }
    store(w, values.work);
    store(bound(loads, side, loss, place), values.load_margin);
  }

  const Lanes* lanes_ = nullptr;
  int order_ = 0, clock_ = plain;
  bool damped_ = false;
  std::array<LaneVector<N>, states> start_ = {};  ///< impulse, work and time start from zero
  std::array<LaneVector<N>, parameters> parameters_;
  LaneVector<N> mobility_;  ///< 1/m*
  const std::array<LaneVector<N>, order_limit + 2>* row_ = nullptr;
  std::unique_ptr<Own<RowField<Pace::plain, false>>> plain_;
  std::unique_ptr<Own<RowField<Pace::plain, true>>> damped_plain_;
  std::unique_ptr<Own<RowField<Pace::landing, false>>> landing_;
  std::unique_ptr<Own<RowField<Pace::landing, true>>> damped_landing_;
  std::unique_ptr<Own<RowField<Pace::general, true>>> general_;
};

/// The series of lane_sizes[size] lanes.
template <std::size_t Size = 0>
inline std::unique_ptr<Expansion> make(std::size_t size) {
  if constexpr (Size + 1 < lane_sizes.size())
    if (size != Size) return make<Size + 1>(size);
  return std::unique_ptr<Expansion>(new RowSeries<lane_sizes[Size] / width>);
}

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
