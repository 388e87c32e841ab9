// The series of a slip from rest in space, the one field that is implicit. Included as `tip_kinds.hpp`.
#pragma once
#include "mariotte/flow/taylor/tip_expansions.hpp"

namespace mariotte::flow::tips::MARIOTTE_INSTRUCTION_SET {

/// A slip from rest, u = ρ û with |û| = 1. Order k of |û|² = 1 gives û_k along û_0. Across it and along it
/// order k of (ρ û)' = u', where ρ_0 = 0, gives the rest of û_k and ρ_{k+1}: u'_k changes with û_k at a known
/// rate, so it is expanded with û_k along û_0 first.
template <class Expansion>
class SlipFromRest {
 public:
  SlipFromRest(Expansion& expansion, const TipStart<SpatialMotion>& from)
      : from_(from),
        expansion_(expansion),
        first_{from.start[from.direction], from.start[from.direction + 1]} {}

  void expand(int order, bool breaking) {
    expansion_.begin(from_.start, from_.parameter);
    const double across = turn_response(from_, across_);
    speed_[1] = breaking ? 0 : along(slip_rate(0));
    for (int k = 1; k <= order; ++k) {
      const double bend = bent(k);
      turn(k, bend, 0);
      const double rest = dot(across_, slip_rate(k)) - (k + 1) * dot(across_, carried(k));
      turn(k, bend, rest / ((k + 1) * speed_[1] - across));
      speed_[k + 1] = along(slip_rate(k)) / (k + 1) - along(carried(k)) - speed_[1] * bend;
    }
  }

 private:
  using Plane = std::array<double, 2>;
  static double dot(const Plane& a, const Plane& b) { return a[0] * b[0] + a[1] * b[1]; }
  double along(const Plane& a) const { return dot(first_, a); }
  Plane at(int row, int k) const { return {expansion_[row][k], expansion_[row + 1][k]}; }
  Plane slip_rate(int k) const { return at(from_.slip_rate, k); }
  Plane direction(int k) const { return at(from_.direction, k); }

  double bent(int k) const {
    double sum = 0;
    for (int j = 1; j < k; ++j) sum -= 0.5 * dot(direction(j), direction(k - j));
    return sum;
  }
  /// Coefficient k + 1 of ρ û without its first and last terms.
  Plane carried(int k) const {
    Plane sum{};
    for (int j = 2; j <= k; ++j)
      for (int i = 0; i < 2; ++i) sum[i] += speed_[j] * direction(k + 1 - j)[i];
    return sum;
  }
  void turn(int k, double bend, double across) {
    for (int i = 0; i < 2; ++i) expansion_[from_.direction + i][k] = bend * first_[i] + across * across_[i];
    expansion_.stage(k);
  }

  const TipStart<SpatialMotion>& from_;
  Expansion& expansion_;
  Plane first_, across_{-first_[1], first_[0]};
  PowerSeries speed_ = {};
};

}  // namespace mariotte::flow::tips::MARIOTTE_INSTRUCTION_SET
