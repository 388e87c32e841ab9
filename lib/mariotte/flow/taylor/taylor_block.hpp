// The series of some registers of contacts. Included by one source file per instruction set, which names the
// namespace they live in.
#pragma once
#include "mariotte/flow/taylor/lane_motion.hpp"
#include "mariotte/flow/taylor/taylor_curves.hpp"
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
  using Maps = std::conditional_t<given == Given::by_neighbours, RowMaps, series::NoMaps>;
  template <class Field>
  using Of = series::Series<Field, order_limit, LaneVector<N>, Maps>;

 public:
  /// As the last expansion says.
  const LaneMotion<N>& motion() const { return motion_; }

  void move_to(int first) { motion_.first = first; }
  /// No contact pushes, and no load is watched that has a power of δ.
  bool is_still() const { return motion_.still; }

  /// Take over what the series starts from; `owner` is the lane of the clock, `pace_start` its √δ.
  void start(const Lanes& lanes, int order, int owner, double pace_start) {
    motion_.lanes = &lanes;
    motion_.order = order;
    motion_.damped = lanes.damped || lanes.general;
    motion_.clocked = owner != Expansion::plain;
    owner_ = owner - motion_.first;
    auto& p = motion_.parameter;
    start_[indentation] = motion_.of(lanes.indentation);
    start_[rate] = motion_.of(lanes.rate);
    p[stiffness] = motion_.of(lanes.stiffness);
    p[steepening] = motion_.of(lanes.steepening);
    p[damping] = motion_.of(lanes.damping);
    p[stiffening] = motion_.of(lanes.stiffening);
    p[ring] = motion_.of(lanes.ring);
    p[power] = motion_.of(lanes.power);
    p[drive] = motion_.of(lanes.drive);
    divide();
    motion_.still = nothing_pushes() && !motion_.has_stretch();
    const auto left = motion_.of(lanes.left), right = motion_.of(lanes.right);
    motion_.mobility = left + right;
    if (!motion_.damped) p[strength] = p[strength] * p[stiffness];
    if constexpr (given == Given::by_neighbours) {
      p[from_left] = left * MARIOTTE_INSTRUCTION_SET::from_left(p[strength]);
      p[from_right] = right * MARIOTTE_INSTRUCTION_SET::from_right(p[strength]);
      p[own] = motion_.mobility * p[strength];
    }
    if (motion_.clocked) start_[clock] = LaneVector<N>(pace_start);
    if (motion_.has_stretch()) hear();
  }

  /// Run `use` on the series that the lanes need.
  template <class Use>
  void with_series(Use&& use) {
    if constexpr (given == Given::from_outside) {
      if (motion_.still) return motion_.clocked ? use(made(still_landing_)) : use(made(still_plain_));
      if (motion_.lanes->widened)
        return motion_.clocked ? use(made(width_landing_)) : use(made(width_plain_));
      if (motion_.lanes->segmented) return with_curves(use);
    }
    if (motion_.lanes->general)
      motion_.lanes->mixed ? use(made(general_mixed_)) : use(made(general_));
    else if (motion_.lanes->mixed)
      motion_.clocked ? use(made(mixed_landing_)) : use(made(mixed_plain_));
    else if (motion_.clocked)
      motion_.damped ? use(made(damped_landing_)) : use(made(landing_));
    else
      motion_.damped ? use(made(damped_plain_)) : use(made(plain_));
  }
  /// Order 0 of that series, and order 1 of its states.
  template <class Field>
  void begin(Of<Field>& series) {
    series.begin(start_, motion_.parameter);
  }
  template <Pace pace>
  void begin(Of<WidthField<pace>>& series) {
    series.begin(width_states(start_, motion_.of(motion_.lanes->width)), width_parameters());
  }
  template <Pace pace, Terms terms>
  void begin(Of<CurveField<pace, terms>>& series) {
    series.begin(start_, curve_numbers<N>(*motion_.lanes, motion_.first, motion_.parameter));
  }
  const std::array<LaneVector<N>, states>& start_states() const { return start_; }
  const std::array<LaneVector<N>, parameters>& parameter_values() const { return motion_.parameter; }

  /// Coefficient k of a row, of all lanes.
  LaneVector<N>& coefficient(int row, int k) { return motion_.coefficient[row][k]; }

 private:
  /// Which contacts push, and which of them, or of those whose load is watched for its rise, have a curved
  /// force. One at zero depth has none yet, unless it owns the clock.
  void divide() {
    auto& p = motion_.parameter;
    const auto push = motion_.of(motion_.lanes->active),
               rises = motion_.loss_of(motion_.of(motion_.lanes->load_side));
    p[chosen] = LaneVector<N>(0.0);
    if (motion_.clocked && owner_ >= 0 && owner_ < N * width)
      p[chosen].part[owner_ / width][owner_ % width] = 1;
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

  /// The load of a slack contact has to be right where nobody feels its force yet: l δᵖ δ as a rate.
  void hear() {
    const auto rises = motion_.loss_of(motion_.of(motion_.lanes->load_side));
    motion_.heard = each<N>([&](int i) {
      const auto share = motion_.parameter[steepening].part[i] / motion_.parameter[damping].part[i];
      return rises.part[i] > Vec{} ? share : Vec{};
    });
  }

  bool nothing_pushes() const {
    Vec any{};
    for (int i = 0; i < N; ++i) any = largest(any, magnitude(motion_.parameter[strength].part[i]));
    for (int i = 0; i < width; ++i)
      if (any[i] > 0) return false;
    return true;
  }

  template <class Field>
  using Held = std::unique_ptr<Of<Field>>;
  template <Pace pace, Terms terms>
  using Own = Held<RowField<pace, terms, given>>;
  template <Pace pace, Terms terms>
  using Curves = Held<CurveField<pace, terms>>;
  template <class Series>
  Series& made(std::unique_ptr<Series>& series) {
    if (!series) series = std::make_unique<Series>();
    if constexpr (given == Given::by_neighbours) series->maps.lane = owner_;
    motion_.coefficient = &(*series)[0];
    return *series;
  }

  template <class Use>
  void with_curves(Use&& use) {
    if (motion_.lanes->general)
      use(made(curves_general_));
    else if (motion_.damped)
      motion_.clocked ? use(made(curves_damped_landing_)) : use(made(curves_damped_plain_));
    else
      motion_.clocked ? use(made(curves_landing_)) : use(made(curves_plain_));
  }

  WidthNumbers<N> width_parameters() {
    const auto numbers = width_numbers<N>(*motion_.lanes, motion_.first);
    auto p = numbers.parameter;
    p[WidthQuantities::owner] = motion_.parameter[chosen];
    p[WidthQuantities::other] = motion_.parameter[free];
    motion_.width_weight = numbers.weight;
    return p;
  }

  LaneMotion<N> motion_;
  int owner_ = 0;                                 ///< lane of the clock, less the first lane
  std::array<LaneVector<N>, states> start_ = {};  ///< impulse, work and time start from zero
  Own<Pace::plain, Terms::elastic> plain_;
  Own<Pace::plain, Terms::viscous> damped_plain_;
  Own<Pace::plain, Terms::mixed> mixed_plain_;
  Own<Pace::landing, Terms::elastic> landing_;
  Own<Pace::landing, Terms::viscous> damped_landing_;
  Own<Pace::landing, Terms::mixed> mixed_landing_;
  Own<Pace::general, Terms::viscous> general_;
  Own<Pace::general, Terms::mixed> general_mixed_;
  Held<WidthField<Pace::plain>> width_plain_;
  Held<WidthField<Pace::landing>> width_landing_;
  Curves<Pace::plain, Terms::elastic> curves_plain_;
  Curves<Pace::plain, Terms::mixed> curves_damped_plain_;
  Curves<Pace::landing, Terms::elastic> curves_landing_;
  Curves<Pace::landing, Terms::mixed> curves_damped_landing_;
  Curves<Pace::general, Terms::mixed> curves_general_;
  Held<StillField<Pace::plain>> still_plain_;
  Held<StillField<Pace::landing>> still_landing_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
