// A step of closed contacts side by side; included as the series are.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <type_traits>

#include "mariotte/flow/lanes/lane_fall.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// Lanes in pairs of contacts, each with the number of the other one.
MARIOTTE_SERIES_INLINE Vec exchanged(Vec a) {
  Vec r;
  for (int i = 0; i < width; ++i) r[i] = a[i ^ 1];
  return r;
}
struct OtherContact {
  template <int>
  MARIOTTE_SERIES_INLINE LaneVector<1> apply(const LaneVector<1>& a) const {
    LaneVector<1> r;
    r.part[0] = exchanged(a.part[0]);
    return r;
  }
};

/// A field F names its rows `root`, √δ of a contact, and `rate`, δ̇, and says of how many contacts it has
/// rows, `contacts`, one after the other. If they `are_paired`, both contacts of one scene stand side by side
/// in them; else each lane holds a scene.
template <class F>
class LaneStep {
 public:
  using Number = LaneVector<1>;
  static constexpr int scenes = F::are_paired ? 1 : width, most_steps = 250;

  static constexpr int row(int first, int j) { return F::are_paired ? first : first + j; }

  void load(int scene, int row, int j, double value) { set(state_[row], j, scene, value); }
  void load_parameter(int scene, int row, int j, double value) { set(parameter_[row], j, scene, value); }
  /// What root and rate of a contact are multiplied by before they are compared with the tolerance.
  void load_weights(int scene, int j, double root, double rate) {
    set(weight_[row(0, j)], j, scene, root);
    set(rate_weight_[row(0, j)], j, scene, rate);
  }
  /// Lanes that would be idle beside a pair repeat it.
  static void set(Number& a, int j, int scene, double value) {
    for (int i = lane(j, scene); i < width; i += F::are_paired ? 2 : width)
      reinterpret_cast<double*>(a.part)[i] = value;
  }

  /// To the place up to which the last coefficients come to the tolerance.
  void advance(const Precision& precision) {
    order_ = precision.order;
    expand();
    end_ = reach(precision.tolerance);
    evaluate();
  }

  double end(int scene) const { return end_[scene]; }
  /// At the end of the step.
  Vec state(int row) const { return state_[row].part[0]; }
  double state(int scene, int row, int j) const { return at(state_[row], j, scene); }
  Vec weight(int i) const { return weight_[i].part[0]; }
  double weight(int scene, int j) const { return at(weight_[row(0, j)], j, scene); }
  /// Of the root of row i, lower ones that are proven.
  Vec bound(int i) const { return bound_[i]; }
  /// The contact is proven to be closed all the while.
  bool remains(int scene, int j) const { return bound_[row(0, j)][lane(j, scene)] > 0; }

  /// Where the root of contact j falls to zero until `end`; proven.
  std::optional<double> first_fall(int scene, int j, double end) const {
    double c[order_limit + 1];
    for (int k = 0; k <= order_; ++k) c[k] = at(series_[row(F::root, j)][k], j, scene);
    return taylor::MARIOTTE_INSTRUCTION_SET::first_fall({c, static_cast<std::size_t>(order_) + 1}, end);
  }

  double value(int scene, int row, int j, double place) const {
    double x = at(series_[row][order_], j, scene);
    for (int k = order_ - 1; k >= 0; --k) x = x * place + at(series_[row][k], j, scene);
    return x;
  }

 private:
  using Maps = std::conditional_t<F::are_paired, OtherContact, series::NoMaps>;

  static constexpr int lane(int j, int scene) { return F::are_paired ? j : scene; }
  static double at(const Number& a, int j, int scene) { return a.part[0][lane(j, scene)]; }

  /// A function of its own, so that its loops have all registers.
  [[gnu::noinline]] void expand() { series_.expand_states(state_, parameter_, order_); }

  Vec reach(double tolerance) const { return least(reach(tolerance, order_ - 1), reach(tolerance, order_)); }
  Vec reach(double tolerance, int k) const {
    Vec most = splat(1e-300);
    for (int i = 0; i < F::contacts; ++i) {
      most = largest(most, weight(i) * magnitude(series_[F::root + i][k].part[0]));
      most = largest(most, rate_weight_[i].part[0] * magnitude(series_[F::rate + i][k].part[0]));
    }
    if constexpr (F::are_paired) most = largest(most, exchanged(most));
    return rough_root(tolerance / most, k);
  }

  /// States at the end of the step, and lower bounds of roots until there.
  void evaluate() {
    const int odd = order_ | 1;
    if (odd > order_) clear(odd);  // terms come by twos
    Vec x[F::states] = {}, loss[F::contacts] = {};
    const auto add = [&](int k) MARIOTTE_SERIES_LAMBDA {
      series::unrolled<F::states>([&](auto i) MARIOTTE_SERIES_LAMBDA {
        x[i] = with_two(x[i], series_[i][k].part[0], series_[i][k - 1].part[0]);
      });
    };
    for (int k = odd; k > 3; k -= 2) {
      add(k);
      for (int i = 0; i < F::contacts; ++i) loss[i] = with_two(loss[i], loss_of(i, k), loss_of(i, k - 1));
    }
    add(3);
    for (int i = 0; i < F::states; ++i) {
      const auto& c = series_[i];  // the largest terms come one by one, which rounds least
      state_[i].part[0] = (x[i] * end_ + c[1].part[0]) * end_ + c[0].part[0];
    }
    bound_roots(loss);
  }
  MARIOTTE_SERIES_INLINE void bound_roots(const Vec* loss) {
    for (int i = 0; i < F::contacts; ++i) {
      const auto& c = series_[F::root + i];
      bound_[i] = lower_bound(c[0].part[0], c[1].part[0], c[2].part[0], c[3].part[0], loss[i], end_);
    }
  }
  /// A sum with the next two terms. Few sums would wait for themselves, so these are added to each other
  /// first.
  MARIOTTE_SERIES_INLINE Vec with_two(Vec sum, Vec c, Vec d) const {
    if constexpr (F::states <= 3)
      return sum * (end_ * end_) + (c * end_ + d);
    else
      return (sum * end_ + c) * end_ + d;
  }
  void clear(int k) {
    for (int i = 0; i < F::states; ++i) series_[i][k].part[0] = Vec{};
  }
  /// What the term k can take away from root i.
  Vec loss_of(int i, int k) const { return largest(-series_[F::root + i][k].part[0], Vec{}); }

  int order_ = 0;
  std::array<Number, F::states> state_;
  std::array<Number, F::parameters> parameter_;
  Number weight_[F::contacts], rate_weight_[F::contacts];
  Vec end_, bound_[F::contacts];
  series::Series<F, order_limit, Number, Maps> series_;
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
