// Triplets side by side, for one instruction set: included by one source file for each, which names the
// namespace.
#pragma once
#include <optional>
#include <span>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/flow/triplet/triplet_field.hpp"
#include "mariotte/flow/triplet/triplet_lanes.hpp"
#include "mariotte/flow/triplet/triplet_pair.hpp"
#include "mariotte/flow/triplet/triplet_start.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

class TripletSeries final : public TripletLanes {
  using F = TripletField;

 public:
  void start(std::span<Triplet* const> triplets, const Precision& precision) override {
    in_groups(triplets, [&](auto group) { start_.run(group, precision); });
  }

  void end_pairs(std::span<Triplet* const> triplets) override {
    in_groups(triplets, [](auto group) { MARIOTTE_INSTRUCTION_SET::end_pairs(group); });
  }

  void follow(std::span<Triplet* const> triplets, const Precision& precision) override {
    waiting_ = triplets;
    precision_ = precision;
    busy_ = 0;
    for (int lane = 0; lane < width; ++lane) take(lane);
    while (busy_ > 0) step();
  }

 private:
  /// Steps that no triplet of the common course takes.
  static constexpr int most_steps = 250;

  static void in_groups(std::span<Triplet* const> triplets, auto&& use) {
    for (std::size_t i = 0; i < triplets.size(); i += width)
      use(triplets.subspan(i, triplets.size() - i < width ? triplets.size() - i : width));
  }

  double& at(LaneVector<1>& row, int lane) { return reinterpret_cast<double*>(row.part)[lane]; }
  double at(int row, int k, int lane) const { return series_[row][k].part[0][lane]; }

  /// The next triplet that waits, or an idle one that never ends.
  void take(int lane) {
    static constexpr Triplet idle{.own = {},
                                  .cross = {},
                                  .weight = {1, 1},
                                  .noise_speed = 0,
                                  .noise_root = 0,
                                  .same_instant = 0,
                                  .rate = {},
                                  .indentation = {1, 1}};
    triplet_[lane] = waiting_.empty() ? nullptr : waiting_.front();
    if (triplet_[lane]) waiting_ = waiting_.subspan(1), ++busy_;
    const Triplet& t = triplet_[lane] ? *triplet_[lane] : idle;
    for (int j = 0; j < 2; ++j) {
      at(state_[F::root0 + j], lane) = __builtin_sqrt(t.indentation[j]);
      at(state_[F::rate0 + j], lane) = t.rate[j];
      at(parameter_[F::own0 + j], lane) = t.own[j];
      at(parameter_[F::cross0 + j], lane) = t.cross[j];
      at(weight_[j], lane) = t.weight[j];
    }
    at(state_[F::time], lane) = t.time;
    at(noise_root_, lane) = t.noise_root;
    steps_[lane] = 0;
  }

  void step() {
    series_.expand_states(state_, parameter_, precision_.order);
    const Vec end = reach();
    evaluate(end);
    const auto above = [&](int j) {
      return weight_[j].part[0] * state_[F::root0 + j].part[0] - noise_root_.part[0];
    };
    const Vec clear = least(least(bound_[0], bound_[1]), least(above(0), above(1)));
    for (int lane = 0; lane < width; ++lane)
      if (++steps_[lane] > most_steps || !(clear[lane] > 0)) look_into(lane, end[lane]);
  }

  /// Where the last coefficients come to the tolerance.
  Vec reach() const {
    const int order = precision_.order;
    return least(reach(order - 1), reach(order));
  }
  Vec reach(int k) const {
    const auto size = [&](int row) { return magnitude(series_[row][k].part[0]); };
    const Vec roots = largest(weight_[0].part[0] * size(F::root0), weight_[1].part[0] * size(F::root1));
    const Vec most = largest(roots, largest(size(F::rate0), size(F::rate1)));
    return rough_root(precision_.tolerance / largest(most, splat(1e-300)), k);
  }

  /// States at the end of the step, and lower bounds of both roots until there.
  void evaluate(Vec end) {
    Vec x[F::states] = {}, loss[2] = {};
    const auto add = [&](int k) MARIOTTE_SERIES_LAMBDA {
      series::unrolled<F::states>(
          [&](auto row) MARIOTTE_SERIES_LAMBDA { x[row] = x[row] * end + series_[row][k].part[0]; });
    };
    for (int k = precision_.order; k >= 4; --k) {
      add(k);
      for (int j = 0; j < 2; ++j) loss[j] = loss[j] * end + largest(-series_[F::root0 + j][k].part[0], Vec{});
    }
    for (int k = 3; k >= 0; --k) add(k);
    for (int row = 0; row < F::states; ++row) state_[row].part[0] = x[row];
    for (int j = 0; j < 2; ++j) {
      const auto& c = series_[F::root0 + j];
      bound_[j] = lower_bound(c[0].part[0], c[1].part[0], c[2].part[0], c[3].part[0], loss[j], end);
    }
  }

  /// A contact may have let go within the step, or not be told from rest.
  void look_into(int lane, double end) {
    Triplet* const t = triplet_[lane];
    if (!t) return;
    double place = end;
    int opens = -1;
    for (int j = 0; j < 2; ++j) {
      if (bound_[j][lane] > 0) continue;
      const auto fall = first_fall(lane, j, place);
      if (fall && *fall < place) place = *fall, opens = j;
    }
    if (opens < 0 && is_sound(lane)) return;
    put(lane, place, *t);
    let_go(*t, opens);
    --busy_;
    take(lane);
  }

  /// Where the root of contact j falls to zero until `end`; proven.
  std::optional<double> first_fall(int lane, int j, double end) const {
    double c[order_limit + 1];
    for (int k = 0; k <= precision_.order; ++k) c[k] = at(F::root0 + j, k, lane);
    const std::span<const double> all(c, static_cast<std::size_t>(precision_.order) + 1);
    if (c[0] > 0 && falls(all, end)) {
      const double last = horner(all, end);
      if (last > 0) return std::nullopt;
      if (const double root = newton(all, end, last); root >= 0 && root <= end) return root;
    }
    return flow::first_fall(all, end);
  }

  /// The root of a polynomial that falls from above zero to `last`, from that of the parabola through its
  /// ends; −1 where it does not come soon.
  static double newton(std::span<const double> c, double end, double last) {
    const double bend = (last - c[0] - c[1] * end) / (end * end), square = c[1] * c[1] - 4 * bend * c[0];
    double x = square > 0 ? 2 * c[0] / (__builtin_sqrt(square) - c[1]) : end;
    for (int i = 0; i < 6; ++i) {
      double value = 0, slope = 0;
      for (std::size_t k = c.size(); k-- > 0;) {
        slope = slope * x + value;
        value = value * x + c[k];
      }
      const double change = value / slope;
      x -= change;
      if (change * change <= epsilon * x * x) return x;  // the next one would be its square
    }
    return -1;
  }

  /// Both contacts are above the noise, and the step is one of not too many.
  bool is_sound(int lane) {
    if (steps_[lane] > most_steps) return false;
    for (int j = 0; j < 2; ++j) {
      const double depth = at(weight_[j], lane) * at(state_[F::root0 + j], lane),
                   rate = at(state_[F::rate0 + j], lane);
      const double speed = rate < 0 ? -rate : rate;
      if (!(depth > at(noise_root_, lane) || speed > triplet_[lane]->noise_speed)) return false;
    }
    return true;
  }

  /// State at a place of the last step.
  void put(int lane, double place, Triplet& t) const {
    double x[F::states];
    for (int row = 0; row < F::states; ++row) {
      x[row] = at(row, precision_.order, lane);
      for (int k = precision_.order - 1; k >= 0; --k) x[row] = x[row] * place + at(row, k, lane);
    }
    for (int j = 0; j < 2; ++j) {
      t.indentation[j] = x[F::root0 + j] * x[F::root0 + j];
      t.rate[j] = x[F::rate0 + j];
    }
    t.time = x[F::time];
    t.series_steps += steps_[lane];
  }

  std::span<Triplet* const> waiting_;
  Precision precision_;
  int busy_ = 0;
  Triplet* triplet_[width];  ///< null where a lane is idle
  int steps_[width];
  std::array<LaneVector<1>, F::states> state_;
  std::array<LaneVector<1>, F::parameters> parameter_;
  LaneVector<1> weight_[2], noise_root_;
  Vec bound_[2];  ///< of the last step
  series::Series<F, order_limit, LaneVector<1>> series_;
  TripletStart start_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
