// Small problems with known answers, that any flow must follow.
#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "mariotte/flow/flow.hpp"

namespace mariotte::test {

/// A problem written as functions. Guards may be as many as wished; the Jacobian is dense and by differences.
class Toy : public flow::Problem {
 public:
  using Field = std::function<void(ConstState, State)>;
  Toy(Index size, Field field, Index guard_count, Field guard, std::vector<flow::Crossing> crossing)
      : size_(size),
        field_(field),
        guard_count_(guard_count),
        guard_(guard),
        crossing_(crossing),
        magnitude_(size, 1.0) {
    for (Index i = 0; i < size; ++i)
      for (Index j = 0; j < size; ++j) pattern_.push_back({i, j});
  }

  Index size() const override { return size_; }
  void derivative(ConstState x, State dx) const override { field_(x, dx); }
  Index guard_count() const override { return guard_count_; }
  void guards(ConstState x, State values) const override { guard_(x, values); }
  void guard_rates(ConstState x, ConstState dx, State rates) const override {
    std::vector<double> ahead(x.begin(), x.end()), behind = ahead, values(guard_count_);
    for (Index i = 0; i < size_; ++i) ahead[i] += 1e-6 * dx[i], behind[i] -= 1e-6 * dx[i];
    guard_(ahead, rates), guard_(behind, values);
    for (Index i = 0; i < guard_count_; ++i) rates[i] = (rates[i] - values[i]) / 2e-6;
  }
  std::span<const flow::Crossing> crossings() const override { return crossing_; }
  std::span<const double> magnitudes() const override { return magnitude_; }
  double time_scale() const override { return 1; }
  std::vector<flow::Entry> pattern() const override { return pattern_; }
  void jacobian(ConstState x, State values) const override {
    std::vector<double> up(x.begin(), x.end()), down = up, f(size_), g(size_);
    for (Index j = 0; j < size_; ++j) {
      up[j] += 1e-6, down[j] -= 1e-6;
      field_(up, f), field_(down, g);
      for (Index i = 0; i < size_; ++i) values[i * size_ + j] = (f[i] - g[i]) / 2e-6;
      up[j] = down[j] = x[j];
    }
  }
  double damping_group() const override { return damping; }
  bool is_ballistic() const override { return ballistic; }
  void second_derivative(ConstState, State ddx) const override { std::fill(ddx.begin(), ddx.end(), 0.0); }
  flow::Accepted accept(ConstState x) override { return accepted ? accepted(x) : flow::Accepted::unchanged; }
  std::string component(Index index) const override { return "x" + std::to_string(index); }

  double damping = 0;                                  ///< the damping group it claims to have
  bool ballistic = false;                              ///< set where the field is constant
  std::function<flow::Accepted(ConstState)> accepted;  ///< what an accepted step has done; nothing if empty

 private:
  Index size_;
  Field field_;
  Index guard_count_;
  Field guard_;
  std::vector<flow::Crossing> crossing_;
  std::vector<double> magnitude_;
  std::vector<flow::Entry> pattern_;
};

/// Guards x − level, one per level.
inline Toy::Field levels_of(std::vector<double> levels) {
  return [levels](ConstState x, State g) {
    for (std::size_t i = 0; i < levels.size(); ++i) g[i] = x[0] - levels[i];
  };
}

/// x'' = −x from (x, v) = (sin φ, cos φ): x = sin(t + φ). Guards as `levels_of`.
inline Toy oscillator(std::vector<double> levels, std::vector<flow::Crossing> crossing) {
  const auto field = [](ConstState x, State dx) {
    dx[0] = x[1];
    dx[1] = -x[0];
  };
  return Toy(2, field, static_cast<Index>(levels.size()), levels_of(levels), crossing);
}

/// x' = rate with the guards of `levels_of`; followed in closed form, without rounding where numbers are
/// short.
struct Ramp : Toy {
  Ramp(double rate, std::vector<double> levels, std::vector<flow::Crossing> crossing)
      : Toy(
            1, [rate](ConstState, State dx) { dx[0] = rate; }, static_cast<Index>(levels.size()),
            levels_of(levels), crossing) {
    ballistic = true;
  }
  void guard_rates(ConstState, ConstState dx, State rates) const override {
    std::fill(rates.begin(), rates.end(), dx[0]);
  }
};

}  // namespace mariotte::test
