// One natural mode of a damped linear system: a pair of functions of time.
#pragma once
#include <array>
#include <complex>

namespace mariotte::flow {

/// Coefficients of a mode's two functions, or their values.
struct Weight {
  double even = 0;
  double odd = 0;
};

/// Two roots of λ² + … = 0 and two functions that span their motions:
///   oscillating  e^{−at} cos wt    e^{−at} sin(wt)/w             λ = −a ± iw, w > 0
///   creeping     e^{−at}           (e^{−at} − e^{−bt})/(b−a)     −a, −b close or equal, b ≥ a
///   separate     e^{−at}           e^{−bt}                       −a, −b apart
/// The first two stay well-defined where the roots meet, at critical damping.
struct NaturalMode {
  enum class Form : unsigned char { oscillating, creeping, separate };
  Form form;
  double decay;   ///< a ≥ 0
  double second;  ///< w, or b

  double fastest() const;  ///< largest |λ|
  double slowest() const;  ///< least |λ|
};

/// The mode of ÿ + 2 damping ẏ + frequency² y = 0.
NaturalMode make_natural_mode(double frequency, double damping);
/// Weights of its motion from y and ẏ at time 0.
Weight motion_from(const NaturalMode& mode, double value, double rate);

/// Weights of the time derivative, and of the integral that is a pure mode, too.
Weight derivative(const NaturalMode& mode, const Weight& weight);
/// Weights of an integral of the motion.
Weight integral(const NaturalMode& mode, const Weight& weight);

/// The two functions at a time, and what they have changed since 0, without cancellation.
struct Swing {
  Weight value;
  Weight change;
};
/// Of a mode at a time since its start.
Swing swing(const NaturalMode& mode, double time);
Weight values(const NaturalMode& mode, double time);  ///< of the functions alone

/// A mode on its way: its functions written as e^{λ₁t} and a second one, which is e^{λ₂t}, or the divided
/// difference of both where the roots are too close for the exponentials to be told apart.
struct Progress {
  std::complex<double> first_root, second_root;
  bool close;
  std::array<std::complex<double>, 2> even, odd;  ///< coefficients of the two
  std::complex<double> first, second;             ///< their values at the time
};
/// Of a mode at a time since its start.
Progress progress(const NaturalMode& mode, double time);

/// ∫₀ᵗ of the products of one mode's functions with another's, both having come to that time.
struct Overlap {
  double even_even, even_odd, odd_even, odd_odd;
};
/// Of two modes that have come to the same time.
Overlap overlap(const Progress& left, const Progress& right, double time);

/// Sum of the products.
inline double dot(const Weight& a, const Weight& b) {
  return a.even * b.even + a.odd * b.odd;
}

}  // namespace mariotte::flow
