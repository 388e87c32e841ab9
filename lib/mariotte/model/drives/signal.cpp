#include "mariotte/model/drives/signal.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mariotte/core/error.hpp"
#include "mariotte/core/monotone_cubic.hpp"

namespace mariotte::model {
namespace {

void expect_growing(const std::vector<SignalPoint>& points) {
  if (points.size() < 2) throw InvalidParameter("a signal needs two points or more");
  if (const auto fall = first_fall(points))
    throw InvalidParameter("point " + std::to_string(*fall + 1) + ": " + std::string(rule_of_signal));
}

/// The cubic from a point to the next with slopes at both.
SignalPiece cubic(const SignalPoint& from, const SignalPoint& to, double first, double last) {
  const double h = to.time - from.time, secant = (to.value - from.value) / h;
  return {.start = from.time,
          .power = {from.value, first, (3 * secant - 2 * first - last) / h,
                    (first + last - 2 * secant) / (h * h)}};
}

SignalPiece constant(const SignalPoint& point) {
  return {.start = point.time, .power = {point.value, 0, 0, 0}};
}

/// ∫ of a piece from its start to a time.
double integral(const SignalPiece& p, double time) {
  const double s = time - p.start, middle = 0.5 * p.frequency * s;
  const auto& c = p.power;
  double sum = s * (c[0] + s * (c[1] / 2 + s * (c[2] / 3 + s * c[3] / 4)));
  if (p.amplitude == 0) return sum;
  // cos α − cos β as a product, which keeps its digits where the piece is short
  const double width = middle == 0 ? s : s * std::sin(middle) / middle;
  return sum + p.amplitude * width * std::sin(p.frequency * p.start + middle + p.phase);
}

double end_of(const Signal& signal, std::size_t i, double otherwise) {
  return i + 1 < signal.piece.size() ? signal.piece[i + 1].start : otherwise;
}

}  // namespace

std::optional<std::size_t> first_fall(const std::vector<SignalPoint>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool grows = i == 0 ? points[i].time == 0 : points[i].time > points[i - 1].time;
    if (!grows || !std::isfinite(points[i].time + points[i].value)) return i;
  }
  return {};
}

Signal sine(double amplitude, double frequency, double phase) {
  return {{{.amplitude = amplitude, .frequency = frequency, .phase = phase}}};
}

Signal half_sine(double amplitude, double duration) {
  if (!(duration > 0) || !std::isfinite(duration))
    throw InvalidParameter("a pulse needs a duration that is positive and finite");
  return {{{.amplitude = amplitude, .frequency = std::numbers::pi / duration}, {.start = duration}}};
}

Signal straight_lines(const std::vector<SignalPoint>& points) {
  expect_growing(points);
  Signal signal;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double slope = (points[i + 1].value - points[i].value) / (points[i + 1].time - points[i].time);
    signal.piece.push_back({.start = points[i].time, .power = {points[i].value, slope, 0, 0}});
  }
  signal.piece.push_back(constant(points.back()));
  return signal;
}

Signal smooth_curve(const std::vector<SignalPoint>& points) {
  expect_growing(points);
  std::vector<double> time, height;
  for (const auto& point : points) {
    time.push_back(point.time);
    height.push_back(point.value);
  }
  const auto slope = monotone_slopes(time, height);
  Signal signal;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    signal.piece.push_back(cubic(points[i], points[i + 1], slope[i], slope[i + 1]));
  signal.piece.push_back(constant(points.back()));
  return signal;
}

Signal rate(const Signal& signal) {
  Signal result;
  for (const auto& piece : signal.piece) result.piece.push_back(rate(piece));
  return result;
}

Index piece_at(const Signal& signal, double time) {
  const auto after = std::upper_bound(signal.piece.begin(), signal.piece.end(), time,
                                      [](double t, const SignalPiece& p) { return t < p.start; });
  return std::max<Index>(0, after - signal.piece.begin() - 1);
}

double integral(const Signal& signal, double time) {
  double sum = 0;
  for (std::size_t i = 0; i < signal.piece.size() && signal.piece[i].start < time; ++i)
    sum += integral(signal.piece[i], std::min(time, end_of(signal, i, time)));
  return sum;
}

namespace {

/// How long piece i holds before `until`; 0 of what has no end.
double duration(const Signal& signal, std::size_t i, double until) {
  const double start = signal.piece[i].start, end = std::min(until, end_of(signal, i, until));
  return std::isfinite(end) ? std::max(0.0, end - start) : 0;
}

/// It swings as far as it can.
bool swings(const SignalPiece& piece, double duration) {
  return piece.amplitude != 0 && (duration == 0 || piece.frequency * duration > 1);
}

}  // namespace

double largest(const Signal& signal, double until) {
  constexpr int samples = 16;
  double most = 0;
  for (std::size_t i = 0; i < signal.piece.size() && signal.piece[i].start < until; ++i) {
    const auto& p = signal.piece[i];
    const double lasts = duration(signal, i, until);
    if (swings(p, lasts)) most = std::max(most, std::abs(p.amplitude));
    for (int k = 0; k <= samples; ++k)
      most = std::max(most, std::abs(value(p, p.start + lasts * k / samples)));
  }
  return most;
}

double largest_integral(const Signal& signal, double until) {
  double most = std::isfinite(until) ? std::abs(integral(signal, until)) : 0;
  for (std::size_t i = 0; i < signal.piece.size() && signal.piece[i].start < until; ++i) {
    const auto& p = signal.piece[i];
    most = std::max(most, std::abs(integral(signal, p.start)));
    if (swings(p, duration(signal, i, until))) most = std::max(most, 2 * std::abs(p.amplitude) / p.frequency);
  }
  return most;
}

Signal scaled(Signal signal, double time, double value) {
  for (auto& p : signal.piece) {
    p.start /= time;
    p.frequency *= time;
    p.amplitude /= value;
    double unit = value;
    for (double& c : p.power) {
      c /= unit;
      unit /= time;
    }
  }
  return signal;
}

}  // namespace mariotte::model
