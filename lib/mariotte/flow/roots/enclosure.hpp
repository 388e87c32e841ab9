// Bounds of a wave and its derivatives over an interval.
#pragma once
#include "mariotte/flow/modal/wave.hpp"

namespace mariotte::flow {

/// Numbers from `low` to `high`.
struct Range {
  double low = 0;
  double high = 0;
};

/// Everything is in units of the interval: s = (t − from)/length, and derivatives are by s. Modes that are
/// slow against the interval enter as one Taylor polynomial, in which they cancel as they should, bounded by
/// its Bernstein coefficients; fast ones enter by their range. Functions of a mode decay, so what bounds them
/// at the start of the interval bounds them all along it.
class Enclosure {
 public:
  Enclosure(const Wave& wave, const std::vector<NaturalMode>& modes, double from, double to);

  Range value() const { return range<0>(); }
  Range rate() const { return range<1>(); }
  Range bend() const { return range<2>(); }

 private:
  static constexpr std::size_t order = 10;    ///< of the polynomial
  static constexpr double slow_angle = 1.25;  ///< a mode is slow if |λ| length is no more
  using Power = std::array<double, order + 1>;

  void add(const NaturalMode& mode, const Weight& weight, double length);
  void add_slow(const NaturalMode& mode, const Weight& weight, double length);
  void add_fading(double decay, double weight, double length);
  void add_turning(const NaturalMode& mode, const Weight& weight, double from, double length);
  void add_fast(const NaturalMode& mode, Weight weight, double length);
  template <int derivative>
  Range range() const;

  Power power_{};                ///< of s, of slow modes and the straight line
  double rest_ = 0;              ///< bound of what the polynomial leaves out; derivatives of it grow by order
  std::array<Range, 3> fast_{};  ///< of value, rate and bend
};

}  // namespace mariotte::flow
