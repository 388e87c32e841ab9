// Natural modes of springs and dampers in a row, each contact with a damping of its own.
#pragma once
#include <complex>
#include <span>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::flow {

/// n+1 bodies, zero inverse mass for walls at the ends, joined by n contacts of force k δ + c δ̇.
struct DampedRow {
  std::span<const double> inverse_mass;
  std::span<const double> stiffness;
  std::span<const double> damping;

  Index contacts() const { return static_cast<Index>(stiffness.size()); }
  bool between_walls() const { return inverse_mass.front() == 0 && inverse_mass.back() == 0; }
};

/// A root λ of the characteristic polynomial as a place −k/c or 0, and what it is off: strongly damped
/// contacts have roots so close to −k/c that the force k + c λ is lost in λ itself.
struct Root {
  double origin;
  std::complex<double> offset;
  std::complex<double> value() const { return origin + offset; }
};

/// Motions e^{λt} of a damped row. Roots come as those above the real axis, then the real ones in pairs, the
/// slower of each pair first.
struct DampedModes {
  std::vector<Root> root;
  std::vector<std::complex<double>> depth;  ///< δ of contact j in mode i at [n i + j]
  std::vector<std::complex<double>> force;  ///< f likewise
  std::vector<std::complex<double>> size;   ///< λ times the bilinear product of mode i with itself
  double condition;                         ///< largest of any root: 1 without damping, ∞ where roots meet
  std::vector<std::complex<double>> left, right, step;  ///< workspace

  /// Coefficient of mode i in the motion that starts from these indentations and rates.
  std::complex<double> amplitude(const DampedRow& row, Index mode, std::span<const double> depth,
                                 std::span<const double> rate) const;
};

/// False if the roots were not found, each apart from all others. All are refined at once [Aberth 1973] on
/// the characteristic polynomial in the form of dynamic stiffnesses, whose terms all have one sign: nothing
/// is lost beside contacts of any other stiffness and damping. The cost does not depend on either.
bool find(DampedModes& modes, const DampedRow& row);

}  // namespace mariotte::flow
