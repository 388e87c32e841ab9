// A step of short rows; included as the series are.
#pragma once
#include "mariotte/flow/lanes/lane_fall.hpp"
#include "mariotte/flow/short_row/short_row_state.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// Of rows with at most N contacts, one in each lane.
template <int N>
class ShortRowStep {
  using F = ShortRowField;
  using Number = LaneVector<N>;

 public:
  using Scene = ShortRow;
  static constexpr int scenes = width, most_steps = 600;
  static constexpr ShortRow idle{};

  void load(int lane, const ShortRow& row) { rows_.load(lane, row); }
  void put(int lane, ShortRow& row) const { rows_.put(lane, row); }

  /// To the place up to which the last coefficients come to the tolerance, or to where a contact changes.
  void advance(const Precision& precision) {
    order_ = precision.order;
    stride_ = rows_.stride;
    for (int& change : change_) change = -1;
    rows_.begin();
    expand();
    end_ = reach(precision.tolerance);
    evaluate();
    if (!all_of(clear_)) find_changes();
  }

  /// Nothing changes within the step, and nothing is about to fade.
  bool is_clear(int lane) const { return clear_[lane]; }
  /// The contact that changes at the end of the step; −1 if none does.
  int change(int lane) const { return change_[lane]; }
  /// It comes to the depth at which its force is heard; else it closes or lets go.
  bool wakes(int lane) const { return rows_.level.part[change_[lane]][lane] > 0; }

 private:
  static constexpr double kept_stride = 0.75;  ///< where steps get short all at once
  static constexpr double safe_radius = 0.7;   ///< share of the radius of convergence that a step may use
  static constexpr double before_last = 300;   ///< times the tolerance that the two terms before may be

  /// A function of its own, so that its loops have all registers.
  [[gnu::noinline]] void expand() { series_.expand_states(rows_.state, rows_.parameter, order_); }

  Vec size(int k) const {
    const auto &depth = series_[F::indentation][k], &rate = series_[F::rate][k];
    Vec most = splat(1e-300);
    for (int j = 0; j < N; ++j)
      most = largest(most, largest(magnitude(rate.part[j]), rows_.weight.part[j] * magnitude(depth.part[j])));
    return most;
  }
  Vec largest_size(int from, int to) const {
    Vec most{};
    for (int k = from; k < to; ++k) most = largest(most, size(k));
    return most;
  }
  /// As Stepper::reach: what coefficients say, and the radius of convergence. After an onset four of five
  /// vanish.
  Vec reach(double tolerance) const {
    Vec end = splat(infinity);
    const auto bound = [&](int k, double most) { return rough_root(most / size(k), k); };
    for (int k = order_ - 1; k <= order_; ++k) end = least(end, bound(k, tolerance));
    Vec later = end;
    for (int k = order_ - 3; k < order_ - 1; ++k) later = least(later, bound(k, before_last * tolerance));
    later = least(later, radius(2));
    if (!any_of(rows_.fresh)) return later;
    for (int k = order_ - 4; k < order_ - 1; ++k) end = least(end, bound(k, tolerance));
    return rows_.fresh ? least(end, radius(5)) : later;
  }
  Vec radius(int group) const {
    const int next = order_ + 1;
    const Vec before = largest_size(next - 2 * group, next - group), last = largest_size(next - group, next);
    return safe_radius * rough_root(before / last, group);
  }

  /// States at the end of the step, and whether all keep their sides until there.
  void evaluate() {
    const auto &depths = series_[F::indentation], &rates = series_[F::rate];
    const auto on = [&](const Number& a, const Number& c) MARIOTTE_SERIES_LAMBDA {
      return each<N>([&](int j) { return end_ * a.part[j] + c.part[j]; });
    };
    auto depth = depths[order_], rate = rates[order_];
    Vec time = series_[F::time][order_].part[0];
    for (int k = order_ - 1; k >= 0; --k) {
      depth = on(depth, depths[k]);
      rate = on(rate, rates[k]);
      time = end_ * time + series_[F::time][k].part[0];
    }
    rows_.stride = largest(time - series_[F::time][0].part[0], kept_stride * stride_);
    rows_.state[F::indentation] = depth;
    rows_.state[F::rate] = rate;
    rows_.state[F::time] = each<N>([&](int) { return time; });
    tell_clear();
  }

  /// Lower bound until the end of the step of a polynomial; what its last term can take away is `loss`.
  MARIOTTE_SERIES_INLINE Vec bound(Vec level, auto&& term, Vec loss) const {
    for (int k = order_ - 1; k >= 4; --k) loss = end_ * loss + largest(-term(k), Vec{});
    return lower_bound(level + term(0), term(1), term(2), term(3), loss, end_);
  }
  /// The root of a depth that ends above zero tells more than the depth: behind a turn near zero it pulls.
  void tell_clear() {
    for (int j = 0; j < N; ++j) {
      const auto waits = rows_.side.part[j] < Vec{};
      const Vec is_deep = rows_.side.part[j] > Vec{} ? rows_.state[F::indentation].part[j] : splat(1);
      const auto term = [&](int k) MARIOTTE_SERIES_LAMBDA {
        return waits ? -series_[F::indentation][k].part[j] : series_[F::root][k].part[j];
      };
      const Vec loss = waits ? largest(series_[F::indentation][order_].part[j], Vec{}) : Vec{};
      remains_[j] = (Mask)(least(bound(rows_.level.part[j], term, loss), is_deep) > Vec{});
    }
    clear_ = remains_[0] & ~rows_.fades(0);
    for (int j = 1; j < N; ++j) clear_ &= remains_[j] & ~rows_.fades(j);
  }

  /// The first contact that changes, of each lane that is not clear.
  void find_changes() {
    const Mask clear = clear_;
    const Vec end = end_;
    for (int lane = 0; lane < width; ++lane)
      for (int j = 0; !clear[lane] && j < N; ++j)
        if (!remains_[j][lane]) look_at(lane, j);
    if (any_of((Mask)(end_ < end))) evaluate();
    clear_ = clear;
    for (int lane = 0; lane < width; ++lane) {
      const int j = change_[lane];
      if (j >= 0) rows_.state[F::indentation].part[j][lane] = rows_.level.part[j][lane];
    }
  }
  /// What comes to zero depth and turns there has not let go.
  void look_at(int lane, int j) {
    const double side = rows_.side.part[j][lane];
    if (side == 0) return end_at(lane, j, polynomial(lane, j, F::clock, 1, 0));
    const auto depth = polynomial(lane, j, F::indentation, side, rows_.level.part[j][lane]);
    end_at(lane, j, depth);
    if (side < 0) return;
    const double end = end_[lane];
    end_at(lane, j, polynomial(lane, j, F::root, 1, 0));
    if (end_[lane] < end && horner(depth, end_[lane]) > 0) change_[lane] = -1;
  }
  void end_at(int lane, int j, const Coefficients& c) {
    const bool is_finite = c[order_] - c[order_] == 0;
    const auto place = is_finite ? first_fall({c.data(), size_t(order_) + 1}, end_[lane]) : std::nullopt;
    if (place && *place < end_[lane]) end_[lane] = *place, change_[lane] = j;
  }
  Coefficients polynomial(int lane, int j, int row, double side, double level) const {
    Coefficients c{};
    for (int k = 0; k <= order_ - (row == F::root); ++k) c[k] = side * series_[row][k].part[j][lane];
    c[0] += level;
    return c;
  }

  int order_ = 0;
  ShortRowState<N> rows_;
  Vec end_, stride_;  ///< of the clock; before the step
  Mask clear_, remains_[N];
  int change_[width];
  series::Series<F, order_limit, Number, ContactMaps> series_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
