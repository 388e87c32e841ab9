// What lanes hold of short rows: a register for each contact, a scene in each lane; included as the series
// are.
#pragma once
#include <array>

#include "mariotte/flow/short_row/short_row.hpp"
#include "mariotte/flow/short_row/short_row_field.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// Neighbours stand beside each other.
struct ContactMaps {
  template <int which, int N>
  MARIOTTE_SERIES_INLINE LaneVector<N> apply(const LaneVector<N>& a) const {
    if constexpr (which == 0) return each<N>([&](int j) { return j > 0 ? a.part[(j + N - 1) % N] : Vec{}; });
    if constexpr (which == 1) return each<N>([&](int j) { return j + 1 < N ? a.part[(j + 1) % N] : Vec{}; });
    Vec sum = a.part[0];
    for (int j = 1; j < N; ++j) sum += a.part[j];
    return each<N>([&](int) { return sum; });
  }
};

/// Of rows with at most N contacts.
template <int N>
struct ShortRowState {
  using F = ShortRowField;
  using Number = LaneVector<N>;

  /// A contact that would let go within this share of the step before is followed in its own clock.
  static constexpr double landing_share = 0.5;

  std::array<Number, F::states> state{};
  std::array<Number, F::parameters> parameter{};
  Number own{}, from_left{}, from_right{}, weight{}, acts_above{}, closed{}, open{};
  Vec stride{};         ///< about the length of the steps before
  Number chosen, side;  ///< whose clock it is; the sign that side × δ + level is to keep, 0 for who is chosen
  Number level;
  Mask fresh;  ///< the clock is that of an onset

  void load(int lane, const ShortRow& row) {
    const auto set = [&](Number& a, int j, double value) { a.part[j][lane] = value; };
    stride[lane] = row.stride;
    for (int j = 0; j < N; ++j) {
      set(own, j, row.own[j]);
      set(from_left, j, row.from_left[j]);
      set(from_right, j, row.from_right[j]);
      set(weight, j, row.weight[j] * row.weight[j]);
      set(acts_above, j, row.acts_above[j]);
      set(closed, j, row.role[j] == RowRole::closed);
      set(open, j, row.role[j] == RowRole::open);
      set(state[F::indentation], j, j < row.contacts ? row.indentation[j] : -1);
      set(state[F::rate], j, row.rate[j]);
      set(state[F::time], j, row.time);
    }
  }
  void put(int lane, ShortRow& row) const {
    for (int j = 0; j < row.contacts; ++j) {
      row.indentation[j] = state[F::indentation].part[j][lane];
      row.rate[j] = state[F::rate].part[j][lane];
    }
    row.time = state[F::time].part[0][lane];
    row.stride = stride[lane];
  }

  /// The clock is that of a contact at its onset, else of the one whose end is nearest, if that is near. A
  /// force is left out until its contact is deep enough, but for the contact that has the clock.
  void begin() {
    const Vec which = nearest();
    fresh = Mask{};
    Number active;
    for (int j = 0; j < N; ++j) {
      const Mask has_clock = (Mask)(which == splat(j));
      chosen.part[j] = has_clock ? splat(1) : Vec{};
      active.part[j] = (Mask)(chosen.part[j] > Vec{}) | is_heard(j) ? splat(1) : Vec{};
      fresh |= has_clock & (Mask)(state[F::rate].part[j] > Vec{});
    }
    take_part(active);
    watch(active);
  }

  Mask is_heard(int j) const {
    const Vec depth = state[F::indentation].part[j], rate = state[F::rate].part[j];
    return (Mask)(closed.part[j] > Vec{}) & (Mask)((depth > acts_above.part[j]) | (rate < Vec{}));
  }

  /// It may be on its way to where it can no more be told from one that has let go.
  Mask fades(int j) const {
    const Vec depth = state[F::indentation].part[j], rate = state[F::rate].part[j];
    return (Mask)((closed.part[j] > Vec{}) & (depth <= acts_above.part[j]) & (rate <= Vec{}));
  }

 private:
  /// The number of the contact that gets the clock, or −1; and that clock.
  Vec nearest() {
    Vec which = splat(-1), depth_of = splat(1), least_time = landing_share * stride;
    for (int j = 0; j < N; ++j) {
      const Vec depth = state[F::indentation].part[j], rate = state[F::rate].part[j];
      const Mask is_struck = (Mask)((depth == Vec{}) & (closed.part[j] > Vec{}) & (rate > Vec{}));
      const Vec left = is_heard(j) & (Mask)(rate < Vec{}) ? depth / -rate : splat(infinity);
      const Mask nearer =
          (is_struck & (Mask)((least_time > Vec{}) | (which < Vec{}))) | (Mask)(left < least_time);
      least_time = nearer ? (is_struck ? Vec{} : left) : least_time;
      which = nearer ? splat(j) : which;
      depth_of = nearer ? depth : depth_of;
    }
    state[F::clock] = each<N>([clock = root(depth_of)](int) { return clock; });
    return which;
  }

  void take_part(const Number& active) {
    auto& p = parameter;
    p[F::chosen] = chosen;
    p[F::free] = Number(1) - chosen;
    p[F::curved] = active * p[F::free];
    p[F::level] = Number(1) - p[F::curved];
    p[F::own] = own * active;
    p[F::from_left] = from_left * ContactMaps().template apply<0>(active);
    p[F::from_right] = from_right * ContactMaps().template apply<1>(active);
  }
  /// What touches and is left out is watched for the depth at which it is heard.
  void watch(const Number& active) {
    for (int j = 0; j < N; ++j) {
      const auto waits = (open.part[j] == Vec{}) & (active.part[j] == Vec{});
      side.part[j] = chosen.part[j] > Vec{} ? Vec{} : active.part[j] > Vec{} ? splat(1) : splat(-1);
      level.part[j] = waits ? heard_at * acts_above.part[j] : Vec{};
    }
  }
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
