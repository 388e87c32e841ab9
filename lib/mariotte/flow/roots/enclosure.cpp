#include "mariotte/flow/roots/enclosure.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::flow {
namespace {

using Form = NaturalMode::Form;

/// C(j, k)/C(n, k): from powers of s on [0, 1] to Bernstein coefficients of degree n; rows are powers k.
template <std::size_t degree>
constexpr auto bernstein = [] {
  std::array<std::array<double, degree + 1>, degree + 1> table{};
  for (std::size_t j = 0; j <= degree; ++j) {
    double ratio = 1;
    for (std::size_t k = 0; k <= j; ++k) {
      table[k][j] = ratio;
      if (k < j) ratio *= static_cast<double>(j - k) / static_cast<double>(degree - k);
    }
  }
  return table;
}();

/// Bounds of Σ power[k] sᵏ over 0 ≤ s ≤ 1.
template <std::size_t size>
Range bounds(const std::array<double, size>& power) {
  std::array<double, size> coefficient{};
  for (std::size_t k = 0; k < size; ++k)
    for (std::size_t j = 0; j < size; ++j) coefficient[j] += bernstein<size - 1>[k][j] * power[k];
  Range range{coefficient[0], coefficient[0]};
  for (const double c : coefficient) {
    range.low = std::min(range.low, c);
    range.high = std::max(range.high, c);
  }
  return range;
}

/// Weights of the same motion with the clock at zero at `time`.
Weight restarted(const NaturalMode& mode, const Weight& weight, double time) {
  const double b = mode.second;
  const auto now = values(mode, time);
  if (mode.form == Form::separate) return {weight.even * now.even, weight.odd * now.odd};
  if (mode.form == Form::creeping) return {dot(weight, now), weight.odd * std::exp(-b * time)};
  return {dot(weight, now), weight.odd * now.even - b * b * weight.even * now.odd};
}

double power_of(double base, std::size_t exponent) {
  double product = 1;
  for (std::size_t i = 0; i < exponent; ++i) product *= base;
  return product;
}

constexpr double factorial(std::size_t n) {
  return n == 0 ? 1 : static_cast<double>(n) * factorial(n - 1);
}

/// 1/(k+1).
constexpr auto inverse = [] {
  std::array<double, 16> table{};
  for (std::size_t k = 0; k < table.size(); ++k) table[k] = 1 / static_cast<double>(k + 1);
  return table;
}();

}  // namespace

Enclosure::Enclosure(const Wave& wave, const std::vector<NaturalMode>& modes, double from, double to) {
  const double length = to - from;
  power_[0] = wave.constant + wave.slope * from;
  power_[1] = wave.slope * length;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    const auto& weight = wave.weight[i];
    if (weight.even == 0 && weight.odd == 0) continue;
    if (modes[i].form == Form::oscillating && modes[i].fastest() * length > slow_angle)
      add_turning(modes[i], weight, from, length);
    else
      add(modes[i], restarted(modes[i], weight, from), length);
  }
}

void Enclosure::add(const NaturalMode& mode, const Weight& weight, double length) {
  if (mode.form == Form::separate) {
    for (const auto& [decay, part] :
         {std::pair(mode.decay, weight.even), std::pair(mode.second, weight.odd)}) {
      if (decay * length <= slow_angle)
        add_fading(decay, part, length);
      else
        add_fast({Form::separate, decay, decay}, {part, 0}, length);
    }
  } else if (mode.fastest() * length > slow_angle) {
    add_fast(mode, weight, length);
  } else {
    add_slow(mode, weight, length);
  }
}

/// weight e^{−at}.
void Enclosure::add_fading(double decay, double weight, double length) {
  double term = weight;
  for (std::size_t k = 0; k <= order; ++k) {
    power_[k] += term;
    term *= -decay * length * inverse[k];
  }
  rest_ += std::abs(term);
}

/// Both forms whose roots may be close: their even function starts at 1, the odd one at 0. The n-th
/// derivative of the odd one, a divided difference, is at most n |λ|ⁿ⁻¹ + t |λ|ⁿ; apart, |λ|ⁿ/w.
void Enclosure::add_slow(const NaturalMode& mode, const Weight& weight, double length) {
  const bool turning = mode.form == Form::oscillating;
  const double a = mode.decay, b = turning ? a : mode.second, turn = turning ? mode.second * mode.second : 0;
  Weight term = weight;
  for (std::size_t k = 0; k <= order; ++k) {
    power_[k] += term.even;
    const double step = length * inverse[k];
    term = {step * (term.odd - a * term.even), -step * (turn * term.even + b * term.odd)};
  }
  constexpr double next = order + 1;
  const double angle = mode.fastest() * length;
  const double close = length * (next + angle) / angle;
  const double odd = turning ? std::min(close, 1 / mode.second) : close;
  rest_ += (std::abs(weight.even) + std::abs(weight.odd) * odd) * power_of(angle, order + 1) /
           factorial(order + 1);
}

/// A fast turning mode by its radius, which each derivative multiplies by |λ|.
void Enclosure::add_turning(const NaturalMode& mode, const Weight& weight, double from, double length) {
  const double angle = mode.fastest() * length, odd = weight.odd / mode.second;
  double radius = std::sqrt(weight.even * weight.even + odd * odd);
  if (mode.decay > 0) radius *= std::exp(-mode.decay * from);
  for (auto& range : fast_) {
    range.low -= radius;
    range.high += radius;
    radius *= angle;
  }
}

void Enclosure::add_fast(const NaturalMode& mode, Weight weight, double length) {
  const double fade = std::exp(-mode.decay * length);
  const double rise = mode.form == Form::creeping ? std::min(length, std::exp(-1.0) / mode.decay) : 0;
  for (auto& range : fast_) {  // e^{−as} between its ends; the odd one of creeping from 0 to at most 1/(e a)
    const double last = weight.even * fade, odd = weight.odd * rise;
    range.low += std::min(weight.even, last) + std::min(0.0, odd);
    range.high += std::max(weight.even, last) + std::max(0.0, odd);
    weight = derivative(mode, weight);
    weight.even *= length;
    weight.odd *= length;
  }
}

/// Of the d-th derivative; what the polynomial leaves out has a Taylor rest of an order less by d.
template <int derivative>
Range Enclosure::range() const {
  std::array<double, order + 1 - derivative> power{};
  double rest = rest_;
  for (std::size_t k = 0; k < power.size(); ++k) {
    power[k] = power_[k + derivative];
    for (std::size_t i = 1; i <= derivative; ++i) power[k] *= static_cast<double>(k + i);
  }
  for (std::size_t i = 0; i < derivative; ++i) rest *= static_cast<double>(order + 1 - i);
  const auto slow = bounds(power);
  const auto& fast = fast_[derivative];
  return {slow.low + fast.low - rest, slow.high + fast.high + rest};
}

template Range Enclosure::range<0>() const;
template Range Enclosure::range<1>() const;
template Range Enclosure::range<2>() const;

}  // namespace mariotte::flow
