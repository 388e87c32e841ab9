// The series of some registers of contacts, their evaluation and bounds. Included by one source file per
// instruction set, which names the namespace they live in.
#pragma once
#include "mariotte/flow/taylor/row_fields.hpp"
#include "mariotte/flow/taylor/taylor_lanes.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/flow/taylor/taylor_widths.hpp"
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

/// The rate of the clock at the start.
inline double pace_start(const Lanes& lanes, int owner) {
  if (owner == Expansion::plain) return 0;
  if (!lanes.widened) return __builtin_sqrt(lanes.indentation[owner]);
  const double u = lanes.width[owner];
  return 4 * u * u * u / lanes.branch[owner]->curve.radius - lanes.branch[owner]->curve.s;
}

/// Lanes `first` to first + N × width of those that are expanded.
template <int N, Given given>
class Block : RowQuantities {
 public:
  static constexpr int size = N * width;

  void move_to(int first) { first_ = first; }
  /// No contact pushes, and no load is watched that has a power of δ.
  bool is_still() const { return still_; }

  /// Take over what the series starts from; `owner` is the lane of the clock, `pace_start` its √δ.
  void start(const Lanes& lanes, int order, int owner, double pace_start) {
    lanes_ = &lanes;
    order_ = order;
    damped_ = lanes.damped || lanes.general;
    clocked_ = owner != Expansion::plain;
    owner_ = owner - first_;
    auto& p = parameters_;
    start_[indentation] = of(lanes.indentation);
    start_[rate] = of(lanes.rate);
    p[stiffness] = of(lanes.stiffness);
    p[steepening] = of(lanes.steepening);
    p[damping] = of(lanes.damping);
    p[stiffening] = of(lanes.stiffening);
    p[power] = of(lanes.power);
    p[drive] = of(lanes.drive);
    divide();
    still_ = nothing_pushes() && !has_stretch();
    const auto left = of(lanes.left), right = of(lanes.right);
    mobility_ = left + right;
    if (!damped_) p[strength] = p[strength] * p[stiffness];
    if constexpr (given == Given::by_neighbours) {
      p[from_left] = left * MARIOTTE_INSTRUCTION_SET::from_left(p[strength]);
      p[from_right] = right * MARIOTTE_INSTRUCTION_SET::from_right(p[strength]);
      p[own] = mobility_ * p[strength];
    }
    if (clocked_) start_[clock] = LaneVector<N>(pace_start);
    if (has_stretch()) hear();
  }

  /// Run `use` on the series that the lanes need.
  template <class Use>
  void with_series(Use&& use) {
    if constexpr (given == Given::from_outside) {
      if (still_) return clocked_ ? use(made(still_landing_)) : use(made(still_plain_));
      if (lanes_->widened) return clocked_ ? use(made(width_landing_)) : use(made(width_plain_));
    }
    if (lanes_->general)
      lanes_->mixed ? use(made(general_mixed_)) : use(made(general_));
    else if (lanes_->mixed)
      clocked_ ? use(made(mixed_landing_)) : use(made(mixed_plain_));
    else if (clocked_)
      damped_ ? use(made(damped_landing_)) : use(made(landing_));
    else
      damped_ ? use(made(damped_plain_)) : use(made(plain_));
  }
  /// Order 0 of that series, and order 1 of its states.
  void begin(auto& series) {
    if constexpr (std::is_same_v<decltype(&series), decltype(width_plain_.get())> ||
                  std::is_same_v<decltype(&series), decltype(width_landing_.get())>)
      series.begin(width_states(start_, of(lanes_->width)), width_parameters());
    else
      series.begin(start_, parameters_);
  }
  const std::array<LaneVector<N>, states>& start_states() const { return start_; }
  const std::array<LaneVector<N>, parameters>& parameter_values() const { return parameters_; }

  /// Coefficient k of a row, of all lanes.
  LaneVector<N>& coefficient(int row, int k) { return row_[row][k]; }
  double at(int row, int k, int lane) const {
    const int i = lane - first_;
    return row_[row][k].part[i / width][i % width];
  }

  double size_of(int k) const {
    const auto weight = of(lanes_->weight);
    Vec most{};
    for (int i = 0; i < N; ++i)
      most = largest(most, largest(magnitude(row_[rate][k].part[i]),
                                   weight.part[i] * magnitude(row_[indentation][k].part[i])));
    for (int i = 0; damped_ && i < N; ++i)
      most = largest(most, mobility_.part[i] * magnitude(row_[work][k].part[i]));
    for (int i = 0; has_stretch() && k < order_ && i < N; ++i)
      most = largest(most, heard_.part[i] * magnitude(row_[stretch][k].part[i]));
    for (int i = 0; lanes_->widened && !still_ && i < N; ++i)
      most = largest(most, width_weight_.part[i] * magnitude(row_[WidthQuantities::width][k].part[i]));
    return largest_of(most);
  }

  void evaluate(double place, Values& values) const {
    const auto side = of(lanes_->side);
    const auto &depths = row_[indentation], &impulses = row_[impulse];
    auto d = depths[order_], p = impulses[order_], amount = magnitude(d);
    int k = order_ - 1;
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
    store(d, values.indentation + first_);
    store(p, values.impulse + first_);
    store(bound(depths, side, edges(), loss, place), values.margin + first_);
    tell_falls(values);
    tell_depths(values);
    if (damped_) evaluate_damped(place, values);
    if (lanes_->branched) evaluate_branches(place, values);
    if (lanes_->widened && !still_) evaluate_widths(place, values);
  }
  double time_at(double place) const {
    if (!clocked_) return place;
    double sum = at(time, order_, first_);
    for (int k = order_ - 1; k >= 0; --k) sum = sum * place + at(time, k, first_);
    return sum;
  }

  void sharpen(double place, Values& values) const {
    constexpr int degree = 9;  // of the terms in Bernstein form; what the others can take away is subtracted
    double factor[degree + 1] = {1};  // placeᵏ/C(degree, k)
    for (int k = 0; k < degree; ++k)
      factor[k + 1] = factor[k] * place * (k + 1) * series::reciprocal.of[degree - k];
    const double beyond = factor[degree] * place;
    const auto side = of(lanes_->side), edge = edges();
    const auto by_root = told_by_root(side, edge, of(values.indentation));
    for (int i = 0; i < N; ++i) {
      auto& margin = *reinterpret_cast<Vec*>(values.margin + first_ + width * i);
      if (!any_of((Mask)(margin < Vec{}))) continue;
      const auto told = by_root.part[i] > Vec{};
      const auto term = [&](int k) {
        return told ? row_[root][k].part[i] : side.part[i] * row_[indentation][k].part[i];
      };
      Vec loss = largest(-side.part[i] * row_[indentation][order_].part[i], Vec{}), b[degree + 1];
      loss = told ? Vec{} : loss;  // the root has no coefficient of that order
      for (int k = order_ - 1; k > degree; --k) loss = place * loss + largest(-term(k), Vec{});
      for (int k = 0; k <= degree; ++k) b[k] = factor[k] * term(k);
      b[0] += told ? Vec{} : edge.part[i];
      for (int row = 1; row <= degree; ++row)  // as in Pascal's triangle
        for (int k = degree; k >= row; --k) b[k] += b[k - 1];
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
        for (int k = 0; k <= order_; ++k)
          c[k] = load_of(k).part[(lane - first_) / width][(lane - first_) % width];
        return;
      case Quantity::root:
        copy(root, lane, c);
        c[order_] = 0;
        return;
      case Quantity::impulse:
        return copy(impulse, lane, c);
      case Quantity::clock:
        return clocked_ ? copy(clock, first_, c) : set_power(0, c);
      case Quantity::time:
        return clocked_ ? copy(time, first_, c) : set_power(1, c);
    }
  }

 private:
  void copy(int row, int lane, double* c) const {
    const auto* from = reinterpret_cast<const double*>(&row_[row]) + (lane - first_);
    for (int k = 0; k <= order_; ++k) c[k] = from[k * size];
  }
  void set_power(int n, double* c) const {
    for (int k = 0; k <= order_; ++k) c[k] = k == n;
  }

  LaneVector<N> of(const double* row) const { return load<N>(row + first_); }
  Mask left_out(int i) const { return (Mask)(of(lanes_->active).part[i] == Vec{}); }
  /// Levels of indentations within a step.
  LaneVector<N> edges() const {
    const auto edge = of(lanes_->level), leeway = of(lanes_->leeway);
    if (!lanes_->has_leeway()) return edge;
    return each<N>([&](int i) { return edge.part[i] + (left_out(i) ? leeway.part[i] : Vec{}); });
  }
  void tell_falls(Values& values) const {
    const auto margin = of(values.margin), depth = of(values.indentation), edge = of(lanes_->level),
               leeway = of(lanes_->leeway);
    Mask any{};
    for (int i = 0; i < N; ++i) {
      const auto is_beyond = (leeway.part[i] > Vec{}) & (depth.part[i] < -edge.part[i]);
      any |= (Mask)(margin.part[i] < Vec{}) | (left_out(i) & (Mask)is_beyond);
    }
    values.may_fall = values.may_fall || any_of(any);
  }
  void tell_depths(Values& values) const {
    const auto depth = of(values.indentation), late = of(lanes_->late_above),
               least_depth = of(lanes_->fades_below), noise = of(lanes_->leaves_noise);
    Mask deep{}, change{};
    for (int i = 0; i < N; ++i) {
      const Vec d = depth.part[i];
      deep |= left_out(i) & (Mask)(d > late.part[i]);
      change |= (Mask)((d < least_depth.part[i]) | (magnitude(d) > noise.part[i]));
    }
    values.is_deep = values.is_deep || any_of(deep);
    values.may_change = values.may_change || any_of(change);
  }
  /// What a term of higher order can take away.
  static LaneVector<N> loss_of(const LaneVector<N>& a) {
    return each<N>([&](int i) { return largest(-a.part[i], Vec{}); });
  }

  /// Which contacts push, and which of them, or of those whose load is watched for its rise, have a curved
  /// force. One at zero depth has none yet, unless it owns the clock.
  void divide() {
    auto& p = parameters_;
    const auto push = of(lanes_->active), rises = loss_of(of(lanes_->load_side));
    p[chosen] = LaneVector<N>(0.0);
    if (clocked_ && owner_ >= 0 && owner_ < size) p[chosen].part[owner_ / width][owner_ % width] = 1;
    p[free] = LaneVector<N>(1.0) - p[chosen];
    for (int i = 0; i < N; ++i) {
      const auto bent = push.part[i] + rises.part[i] * p[steepening].part[i];
      const auto sharp = p[power].part[i] * bent != Vec{};
      const auto deep = start_[indentation].part[i] > Vec{}, owner = p[chosen].part[i] != Vec{};
      p[curved].part[i] = sharp & deep & ~owner ? splat(1) : Vec{};
      p[level].part[i] = splat(1) - p[curved].part[i];
      p[strength].part[i] = sharp & ~deep & ~owner ? Vec{} : push.part[i];
    }
  }

  /// 1 where √δ is expanded and tells that δ stays positive, and so above its level: it falls less steeply.
  LaneVector<N> told_by_root(const LaneVector<N>& side, const LaneVector<N>& edge,
                             const LaneVector<N>& end) const {
    if (lanes_->widened || still_) return LaneVector<N>(0.0);
    return each<N>([&](int i) {
      const auto told = (side.part[i] > Vec{}) & (edge.part[i] >= Vec{}) & (end.part[i] > Vec{});
      return told ? parameters_[curved].part[i] : Vec{};
    });
  }

  /// The load of a slack contact has to be right where nobody feels its force yet: l δᵖ δ as a rate.
  void hear() {
    const auto rises = loss_of(of(lanes_->load_side));
    heard_ = each<N>([&](int i) {
      const auto share = parameters_[steepening].part[i] / parameters_[damping].part[i];
      return rises.part[i] > Vec{} ? share : Vec{};
    });
  }

  bool nothing_pushes() const {
    Vec any{};
    for (int i = 0; i < N; ++i) any = largest(any, magnitude(parameters_[strength].part[i]));
    for (int i = 0; i < width; ++i)
      if (any[i] > 0) return false;
    return true;
  }

  using Maps = std::conditional_t<given == Given::by_neighbours, RowMaps, series::NoMaps>;
  template <class Field>
  using Of = std::unique_ptr<series::Series<Field, order_limit, LaneVector<N>, Maps>>;
  template <Pace pace, Terms terms>
  using Own = Of<RowField<pace, terms, given>>;
  template <class Series>
  Series& made(std::unique_ptr<Series>& series) {
    if (!series) series = std::make_unique<Series>();
    if constexpr (given == Given::by_neighbours) series->maps.lane = owner_;
    row_ = &(*series)[0];
    return *series;
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

  bool has_stretch() const { return lanes_->general && lanes_->mixed && !lanes_->widened; }
  /// Coefficient k of the loads, but for the last one of l δᵖ δ.
  LaneVector<N> load_of(int k) const {
    const auto& p = parameters_;
    const auto viscous = p[stiffness] * row_[indentation][k] + p[damping] * row_[rate][k];
    if (!lanes_->mixed) return viscous;
    const bool stretches = has_stretch() && k < order_;
    return each<N>([&](int i) {
      const auto multiplied =
          p[stiffening].part[i] * row_[rate][k].part[i] + (k == 0 ? p[stiffness].part[i] : Vec{});
      const auto stretched = stretches ? p[steepening].part[i] * row_[stretch][k].part[i] : Vec{};
      return p[stiffening].part[i] > Vec{} ? multiplied : viscous.part[i] + stretched;
    });
  }

  void evaluate_damped(double place, Values& values) const {
    LaneVector<N> loads[order_limit + 1];
    const auto& works = row_[work];
    for (int k = 0; k <= order_; ++k) loads[k] = load_of(k);
    const auto side = of(lanes_->load_side);
    auto w = works[order_], loss = loss_of(side * loads[order_]);
    for (int k = order_ - 1; k >= 0; --k) {
      w = place * w + works[k];
      if (k >= 4) loss = place * loss + loss_of(side * loads[k]);
    }
    store(w, values.work + first_);
    store(bound(loads, side, LaneVector<N>(0.0), loss, place), values.load_margin + first_);
  }

  WidthNumbers<N> width_parameters() {
    const auto numbers = width_numbers<N>(*lanes_, first_);
    auto p = numbers.parameter;
    p[WidthQuantities::owner] = parameters_[chosen];
    p[WidthQuantities::other] = parameters_[free];
    width_weight_ = numbers.weight;
    return p;
  }
  void evaluate_widths(double place, Values& values) const {
    const auto& widths = row_[WidthQuantities::width];
    auto u = widths[order_];
    for (int k = order_ - 1; k >= 0; --k) u = place * u + widths[k];
    store(u, values.width + first_);
  }

  void evaluate_branches(double place, Values& values) const {
    const auto &depths = row_[indentation], &rates = row_[rate];
    const auto below = -of(lanes_->yield_side), side = of(lanes_->turn_side);
    auto loss = loss_of(below * depths[order_]), rate_loss = loss_of(side * rates[order_]);
    for (int k = order_ - 1; k >= 4; --k) {
      loss = place * loss + loss_of(below * depths[k]);
      rate_loss = place * rate_loss + loss_of(side * rates[k]);
    }
    const auto yields = bound(depths, below, of(lanes_->yield_level), loss, place),
               turns = bound(rates, side, of(lanes_->turn_level), rate_loss, place);
    store(each<N>([&](int i) { return least(yields.part[i], turns.part[i]); }),
          values.branch_margin + first_);
  }

  const Lanes* lanes_ = nullptr;
  int first_ = 0, order_ = 0;
  int owner_ = 0;  ///< lane of the clock, less the first lane
  bool damped_ = false, clocked_ = false, still_ = false;
  std::array<LaneVector<N>, states> start_ = {};  ///< impulse, work and time start from zero
  std::array<LaneVector<N>, parameters> parameters_;
  LaneVector<N> mobility_;      ///< 1/m*
  LaneVector<N> heard_;         ///< l/c of a slack contact whose load is watched, else 0
  LaneVector<N> width_weight_;  ///< 1/u
  std::array<LaneVector<N>, order_limit + 2>* row_ = nullptr;
  Own<Pace::plain, Terms::elastic> plain_;
  Own<Pace::plain, Terms::viscous> damped_plain_;
  Own<Pace::plain, Terms::mixed> mixed_plain_;
  Own<Pace::landing, Terms::elastic> landing_;
  Own<Pace::landing, Terms::viscous> damped_landing_;
  Own<Pace::landing, Terms::mixed> mixed_landing_;
  Own<Pace::general, Terms::viscous> general_;
  Own<Pace::general, Terms::mixed> general_mixed_;
  Of<WidthField<Pace::plain>> width_plain_;
  Of<WidthField<Pace::landing>> width_landing_;
  Of<StillField<Pace::plain>> still_plain_;
  Of<StillField<Pace::landing>> still_landing_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
