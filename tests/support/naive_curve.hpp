// A force through points as the naive simulator has it: cubics of Hermite with slopes of Fritsch and Butland,
// written once more.
#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

#include "mariotte/contact/tabulated.hpp"

namespace mariotte::test {

class NaiveCurve {
 public:
  NaiveCurve() = default;
  explicit NaiveCurve(const CubicCurve& curve) {
    for (const auto& segment : curve) points_.push_back({segment.from, segment.a[0]});
    const auto last = points_.size() - 1;
    for (std::size_t i = 0; i <= last; ++i)
      slopes_.push_back(i == 0 ? at_end(0, 1) : i == last ? at_end(last - 1, last - 2) : mean(i));
  }
  bool is_given() const { return !points_.empty(); }

  double force(double depth) const {
    if (!(depth > 0)) return 0;
    const auto& last = points_.back();
    if (depth >= last.indentation) return last.force + slopes_.back() * (depth - last.indentation);
    std::size_t i = 0;
    while (points_[i + 1].indentation <= depth) ++i;
    const double h = width(i), s = (depth - points_[i].indentation) / h, r = 1 - s;
    return points_[i].force * r * r * (1 + 2 * s) + points_[i + 1].force * s * s * (1 + 2 * r) +
           h * s * r * (slopes_[i] * r - slopes_[i + 1] * s);
  }
  /// Where about an energy is stored.
  double depth_of(double energy) const {
    double depth = points_[1].indentation;
    while (force(depth) * depth < 2 * energy) depth *= 1.1;
    while (force(depth) * depth > 2 * energy) depth /= 1.1;
    return depth;
  }

 private:
  double width(std::size_t i) const { return points_[i + 1].indentation - points_[i].indentation; }
  double secant(std::size_t i) const { return (points_[i + 1].force - points_[i].force) / width(i); }
  /// All rise.
  double mean(std::size_t i) const {
    const double one = 2 * width(i) + width(i - 1), two = width(i) + 2 * width(i - 1);
    return (one + two) / (one / secant(i - 1) + two / secant(i));
  }
  /// Of the parabola through the three points at an end, whose segments are these.
  double at_end(std::size_t own, std::size_t next) const {
    if (points_.size() == 2) return secant(0);
    const double one = secant(own), h = width(own);
    return std::clamp(one + (one - secant(next)) * h / (h + width(next)), 0.0, 3 * one);
  }

  std::vector<contact::LawPoint> points_;
  std::vector<double> slopes_;
};

}  // namespace mariotte::test
