#include "mariotte/flow/mode.hpp"

#include <cmath>

namespace mariotte::flow {
namespace {

using Complex = std::complex<double>;
using Form = NaturalMode::Form;

/// (e^{−at} − e^{−bt})/(b−a), where both may be equal.
double between(double a, double b, double time) {
  const double gap = b - a, fade = std::exp(-a * time);
  return gap > 0 ? fade * -std::expm1(-gap * time) / gap : fade * time;
}

/// (e^z − 1)/z, given e^z.
Complex growth(Complex z, Complex exponential) {
  const double square = z.real() * z.real() + z.imag() * z.imag();
  if (square > 0.25) return (exponential - 1.0) * std::conj(z) / square;
  Complex sum = 1;
  for (int k = 14; k > 1; --k) sum = 1.0 + sum * z * (1.0 / k);
  return sum;
}

}  // namespace

double NaturalMode::fastest() const {
  if (form != Form::oscillating) return second;
  return decay == 0 ? second : std::hypot(decay, second);
}
double NaturalMode::slowest() const {
  return form == Form::oscillating ? fastest() : decay;
}

NaturalMode make_natural_mode(double frequency, double damping) {
  const double split = std::sqrt(std::abs((frequency - damping) * (frequency + damping)));
  if (split > 0 && damping < frequency) return {Form::oscillating, damping, split};
  const double fast = damping + split, slow = frequency / fast * frequency;
  return {fast > 3 * slow ? Form::separate : Form::creeping, slow, fast};
}

Weight motion_from(const NaturalMode& mode, double value, double rate) {
  const double a = mode.decay, b = mode.second;
  if (mode.form != Form::separate) return {value, rate + a * value};
  return {(rate + b * value) / (b - a), -(rate + a * value) / (b - a)};
}

Weight derivative(const NaturalMode& mode, const Weight& w) {
  const double a = mode.decay, b = mode.second;
  if (mode.form == Form::oscillating) return {w.odd - a * w.even, -b * b * w.even - a * w.odd};
  if (mode.form == Form::creeping) return {w.odd - a * w.even, -b * w.odd};
  return {-a * w.even, -b * w.odd};
}

Weight integral(const NaturalMode& mode, const Weight& w) {
  const double a = mode.decay, b = mode.second;
  const double square = a * a + b * b;
  if (mode.form == Form::oscillating)
    return {-(a * w.even + w.odd) / square, (b * b * w.even - a * w.odd) / square};
  if (mode.form == Form::creeping) return {-(w.even + w.odd / b) / a, -w.odd / b};
  return {-w.even / a, -w.odd / b};
}

Weight values(const NaturalMode& mode, double time) {
  const double a = mode.decay, b = mode.second;
  if (mode.form == Form::separate) return {std::exp(-a * time), std::exp(-b * time)};
  if (mode.form == Form::creeping) return {std::exp(-a * time), between(a, b, time)};
  const double fade = a == 0 ? 1 : std::exp(-a * time);
  return {fade * std::cos(b * time), fade * std::sin(b * time) / b};
}

Swing swing(const NaturalMode& mode, double time) {
  const double a = mode.decay, b = mode.second;
  if (mode.form == Form::oscillating) {
    const double sine = std::sin(b * time), cosine = std::cos(b * time);
    const double turned = cosine > 0 ? -sine * sine / (1 + cosine) : cosine - 1;
    if (a == 0) return {{cosine, sine / b}, {turned, sine / b}};
    const double fade = std::exp(-a * time), odd = fade * sine / b;
    return {{fade * cosine, odd}, {std::expm1(-a * time) * cosine + turned, odd}};
  }
  const Weight value = values(mode, time);
  return {value, {std::expm1(-a * time), mode.form == Form::separate ? std::expm1(-b * time) : value.odd}};
}

Progress progress(const NaturalMode& mode, double time) {
  const double a = mode.decay, b = mode.second;
  if (mode.form != Form::oscillating) {
    const Weight value = values(mode, time);
    return {-a, -b, mode.form == Form::creeping, {1, 0}, {0, 1}, value.even, value.odd};
  }
  const Complex root(-a, b), turn(0, b);
  const double fade = std::exp(-a * time), cosine = std::cos(b * time), sine = std::sin(b * time);
  const Complex first = fade * Complex(cosine, sine);
  if (b < 0.1 * a) return {root, std::conj(root), true, {1, -turn}, {0, 1}, first, fade * sine / b};
  return {root,  std::conj(root), false, {0.5, 0.5}, {Complex(0, -0.5 / b), Complex(0, 0.5 / b)},
          first, std::conj(first)};
}

namespace {

/// ∫₀ᵗ e^{root t}, given its integrand at the end.
Complex grown(Complex root, Complex value, double time) {
  return time * growth(root * time, value);
}

/// Of two modes that turn: products of sines and cosines are those of sum and difference.
Overlap turning_overlap(const Progress& l, const Progress& r, double time) {
  const Complex sum = 0.5 * grown(l.first_root + r.first_root, l.first * r.first, time);
  const Complex difference = 0.5 * grown(l.first_root + r.second_root, l.first * r.second, time);
  const double left = 1 / l.first_root.imag(), right = 1 / r.first_root.imag();
  return {(sum + difference).real(), right * (sum - difference).imag(), left * (sum + difference).imag(),
          left * right * (difference - sum).real()};
}

}  // namespace

/// A divided difference obeys y' = first + λ₂y, so that its products integrate by parts; its root decays, so
/// no denominator vanishes.
Overlap overlap(const Progress& l, const Progress& r, double time) {
  if (!l.close && !r.close && l.first_root.imag() > 0 && r.first_root.imag() > 0)
    return turning_overlap(l, r, time);
  const auto plain = [&](Complex root, Complex value) { return grown(root, value, time); };
  const Complex j11 = plain(l.first_root + r.first_root, l.first * r.first);
  const auto by_parts = [](Complex value, Complex rest, Complex root) { return (value - rest) / root; };
  const Complex root12 = l.first_root + r.second_root, root21 = l.second_root + r.first_root,
                root22 = l.second_root + r.second_root;
  const Complex y12 = l.first * r.second, y21 = l.second * r.first, y22 = l.second * r.second;
  const Complex j12 = r.close ? by_parts(y12, j11, root12) : plain(root12, y12);
  const Complex j21 = l.close ? by_parts(y21, j11, root21) : plain(root21, y21);
  const Complex rest = (l.close ? j12 : 0.0) + (r.close ? j21 : 0.0);
  const Complex j22 = l.close || r.close ? by_parts(y22, rest, root22) : plain(root22, y22);
  const auto combine = [&](const std::array<Complex, 2>& a, const std::array<Complex, 2>& b) {
    return (a[0] * (b[0] * j11 + b[1] * j12) + a[1] * (b[0] * j21 + b[1] * j22)).real();
  };
  return {combine(l.even, r.even), combine(l.even, r.odd), combine(l.odd, r.even), combine(l.odd, r.odd)};
}

}  // namespace mariotte::flow
