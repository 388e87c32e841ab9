#include "mariotte/flow/wave.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mariotte/core/bracket.hpp"
#include "mariotte/core/types.hpp"

namespace mariotte::flow {
namespace {

using std::numbers::pi;

constexpr std::size_t order = 10;   ///< of the polynomial for slow modes
constexpr double slow_angle = 1.5;  ///< a mode is slow if it turns by no more over the interval
constexpr int deepest = 60;         ///< halvings until an interval is shorter than rounding

struct Range {
  double low = 0;
  double high = 0;
};

/// C(j, k)/C(order, k): from powers of s on [0, 1] to Bernstein coefficients.
constexpr auto bernstein = [] {
  std::array<std::array<double, order + 1>, order + 1> table{};
  for (std::size_t j = 0; j <= order; ++j) {
    double ratio = 1;
    for (std::size_t k = 0; k <= j; ++k) {
      table[j][k] = ratio;
      if (k < j) ratio *= static_cast<double>(j - k) / static_cast<double>(order - k);
    }
  }
  return table;
}();

/// Bounds of Σ power[k] sᵏ over 0 ≤ s ≤ 1.
Range bounds(const std::array<double, order + 1>& power) {
  Range range{infinity, -infinity};
  for (std::size_t j = 0; j <= order; ++j) {
    double coefficient = 0;
    for (std::size_t k = 0; k <= j; ++k) coefficient += bernstein[j][k] * power[k];
    range.low = std::min(range.low, coefficient);
    range.high = std::max(range.high, coefficient);
  }
  return range;
}

/// Exact range of sin over [from, to]: the ends, and ±1 where a crest or a trough lies between.
Range sine_over(double from, double to) {
  if (to - from >= 2 * pi) return {-1, 1};
  const double a = std::sin(from), b = std::sin(to);
  const auto holds = [&](double angle) {
    return angle + 2 * pi * std::ceil((from - angle) / (2 * pi)) <= to;
  };
  return {holds(-pi / 2) ? -1 : std::min(a, b), holds(pi / 2) ? 1 : std::max(a, b)};
}

void add(Range& sum, double factor, const Range& term) {
  sum.low += factor * (factor > 0 ? term.low : term.high);
  sum.high += factor * (factor > 0 ? term.high : term.low);
}

/// Value, and rate times length, of a wave over an interval; s = (t − from)/length.
struct Enclosure {
  std::array<double, order + 1> value{}, rate{};
  Range fast_value, fast_rate;
  double value_rest = 0, rate_rest = 0;

  void add_slow(double factor, const Mode& mode, double from, double length) {
    const double angle = mode.frequency * length, turn = mode.frequency * from + mode.phase;
    const double size = factor * mode.amplitude, sine = size * std::sin(turn), cosine = size * std::cos(turn);
    const std::array<double, 4> cycle = {sine, cosine, -sine, -cosine};
    double power = 1;
    for (std::size_t k = 0; k <= order; ++k) {
      value[k] += power * cycle[k % 4];
      rate[k] += power * angle * cycle[(k + 1) % 4];
      power *= angle / static_cast<double>(k + 1);
    }
    value_rest += std::abs(size) * power;
    rate_rest += std::abs(size) * power * angle;
  }
  void add_fast(double factor, const Mode& mode, double from, double length) {
    const double a = mode.frequency * from + mode.phase, b = a + mode.frequency * length;
    const double size = factor * mode.amplitude;
    add(fast_value, size, sine_over(a, b));
    add(fast_rate, size * mode.frequency * length, sine_over(a + pi / 2, b + pi / 2));
  }
  Range value_range() const { return widened(bounds(value), fast_value, value_rest); }
  Range rate_range() const { return widened(bounds(rate), fast_rate, rate_rest); }

 private:
  static Range widened(const Range& slow, const Range& fast, double rest) {
    return {slow.low + fast.low - rest, slow.high + fast.high + rest};
  }
};

Enclosure enclose(const Wave& wave, const std::vector<Mode>& modes, double from, double to) {
  const double length = to - from;
  Enclosure e;
  e.value[0] = wave.constant + wave.slope * from;
  e.value[1] = e.rate[0] = wave.slope * length;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i].frequency * length <= slow_angle)
      e.add_slow(wave.weight[i], modes[i], from, length);
    else
      e.add_fast(wave.weight[i], modes[i], from, length);
  }
  return e;
}

/// The wave is positive, or rising from zero, at `from`.
std::optional<double> search(const Wave& wave, const std::vector<Mode>& modes, double from, double to,
                             int depth) {
  const auto enclosure = enclose(wave, modes, from, to);
  if (enclosure.value_range().low > 0) return std::nullopt;
  const auto rate = enclosure.rate_range();
  if (rate.low >= 0) return std::nullopt;
  if (rate.high <= 0 || depth == deepest) {
    const double first = wave.at(modes, from), last = wave.at(modes, to);
    if (last > 0) return std::nullopt;
    if (!(first > 0)) return from;
    return locate_sign_change([&](double time) { return wave.at(modes, time); }, from, first, to, last,
                              epsilon * to);
  }
  const double middle = 0.5 * (from + to);
  if (const auto early = search(wave, modes, from, middle, depth + 1)) return early;
  return search(wave, modes, middle, to, depth + 1);
}

}  // namespace

double Mode::at(double time) const {
  return amplitude * std::sin(frequency * time + phase);
}
double Mode::rate(double time) const {
  return amplitude * frequency * std::cos(frequency * time + phase);
}

double Wave::at(const std::vector<Mode>& modes, double time) const {
  double sum = constant + slope * time;
  for (std::size_t i = 0; i < modes.size(); ++i) sum += weight[i] * modes[i].at(time);
  return sum;
}
double Wave::rate(const std::vector<Mode>& modes, double time) const {
  double sum = slope;
  for (std::size_t i = 0; i < modes.size(); ++i) sum += weight[i] * modes[i].rate(time);
  return sum;
}

std::optional<double> first_fall(const Wave& wave, const std::vector<Mode>& modes, double from, double to) {
  return search(wave, modes, from, to, 0);
}

}  // namespace mariotte::flow
