// The first moments of triplets whose contacts start undeformed, side by side; included as the series are.
//
// With z = t^{5/2}, or z = t^{5/4} where contact b touches at rest, and powers of t in front of b's then:
//   δ = t D(z),  δ̇ = W(z),   of b: δ = t^{7/2} D(z),  δ̇ = t^{5/2} W(z)
#pragma once
#include <span>

#include "mariotte/flow/taylor/start_powers.hpp"
#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/flow/taylor/taylor_stepper.hpp"
#include "mariotte/flow/triplet/triplet.hpp"

namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET {

/// How the coefficients k of a contact follow: from which ones of both forces, and by which integrals.
struct StartRule {
  int own, given;  ///< force k − own of itself, k − given of the other
  Reciprocals rate, indentation;
};
inline constexpr StartRule both_struck{1, 1, {0, 2.5}, {1, 2.5}}, striking{2, 5, {0, 1.25}, {1, 1.25}},
    pressed{3, 0, {2.5, 1.25}, {3.5, 1.25}};

/// Of at most `width` triplets.
class TripletStart {
 public:
  void run(std::span<Triplet* const> triplets, const Precision& precision) {
    load(triplets);
    order_ = pressed_ ? more_than(precision.order) : precision.order;
    expand();
    const double power = order_ * (pressed_ ? 1.25 : 2.5);
    Vec last{};
    for (int k = order_ - 2; k <= order_; ++k)
      for (const auto& one : contact_) last = largest(last, magnitude(one.rate[k].part[0]));
    store(triplets, shortened(0.9 * rough_root(precision.tolerance / largest(last, splat(1e-300)), power)));
  }

 private:
  using Number = LaneVector<1>;
  struct Contact : StartPowers<Number> {
    Coefficients rate;
    Number own, cross;
  };

  /// Powers of t^{5/4} are half as far apart as those of t^{5/2}: some more of them save a step or two.
  static int more_than(int order) {
    constexpr int more = 3;
    return order + more < order_limit ? order + more : order_limit;
  }

  /// Contact a is struck, and b struck as well or pressed.
  void load(std::span<Triplet* const> triplets) {
    pressed_ = triplets.front()->stage == TripletStage::pressed;
    for (int lane = 0; lane < width; ++lane) {
      const auto& t = *triplets[lane < std::ssize(triplets) ? lane : 0];
      for (int i = 0; i < 2; ++i) {
        const int j = t.striker ^ i;
        contact_[i].rate[0].part[0][lane] = t.rate[j];
        contact_[i].own.part[0][lane] = t.own[j];
        contact_[i].cross.part[0][lane] = t.cross[j];
      }
    }
  }

  void expand() {
    for (int k = 0; k <= order_; ++k)
      for (int i = 0; i < 2; ++i) {
        const auto& rule = !pressed_ ? both_struck : i == 0 ? striking : pressed;
        auto& one = contact_[i];
        if (k > 0 || (pressed_ && i == 1))
          one.rate[k] = rule.rate.of[k] * pushed(one, contact_[1 - i], rule, k);
        one.indentation[k] = rule.indentation.of[k] * one.rate[k];
        one.next(k, Number(1.0));
      }
  }
  static Number pushed(const Contact& one, const Contact& other, const StartRule& rule, int k) {
    Number push = k >= rule.given ? one.cross * other.force[k - rule.given] : Number(0.0);
    if (k >= rule.own) push = push - one.own * one.force[k - rule.own];
    return push;
  }

  Vec power_of(Vec time) const {
    const Vec half = root(time);
    return pressed_ ? time * root(half) : time * time * half;
  }

  /// Halved until both contacts are proven to be closed all the while.
  Vec shortened(Vec time) const {
    for (int tries = 0; tries < 8 && !all_of(is_closed(time)); ++tries)
      time = is_closed(time) ? time : 0.5 * time;
    return time;
  }
  Mask is_closed(Vec time) const {
    const Vec z = power_of(time);
    return least(bound(contact_[0], z), bound(contact_[1], z)) > Vec{};
  }
  Vec bound(const Contact& one, Vec z) const {
    const auto& d = one.indentation;
    Vec loss{};
    for (int k = order_; k >= 4; --k) loss = loss * z + largest(-d[k].part[0], Vec{});
    return lower_bound(d[0].part[0], d[1].part[0], d[2].part[0], d[3].part[0], loss, z);
  }

  Vec sum(const Number* c, Vec z) const {
    Vec total = c[order_].part[0];
    for (int k = order_ - 1; k >= 0; --k) total = total * z + c[k].part[0];
    return total;
  }

  void store(std::span<Triplet* const> triplets, Vec time) const {
    const Vec z = power_of(time);
    for (int i = 0; i < 2; ++i) {
      const auto& one = contact_[i];
      const Vec later = pressed_ && i == 1 ? z * z : splat(1);
      const Vec depth = later * time * sum(one.indentation.data(), z), rate = later * sum(one.rate.data(), z);
      for (int lane = 0; lane < std::ssize(triplets); ++lane) {
        auto& t = *triplets[lane];
        t.indentation[t.striker ^ i] = depth[lane];
        t.rate[t.striker ^ i] = rate[lane];
      }
    }
    const Mask certain = is_closed(time);
    for (int lane = 0; lane < std::ssize(triplets); ++lane)
      begin_series(*triplets[lane], time[lane], certain[lane]);
  }

  bool pressed_ = false;
  int order_ = 0;
  Contact contact_[2];
};

}  // namespace mariotte::flow::taylor::MARIOTTE_INSTRUCTION_SET
