// A chain in units of order one, with the natural sizes that tolerances are relative to.
#pragma once
#include <vector>

#include "mariotte/core/scale.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::model {

/// The chain divided by `scale`. Contact j alone, struck at the reference speed, would indent by about
/// length[j] within about time[j] [Acary 2003, §2.2]: L = (m* v²/k)^{1/(n+1)}, T = L/v with m* the reduced
/// mass.
struct DimensionlessChain {
  Scale scale;
  std::vector<double> mass, inverse_mass;  ///< n values; 1/∞ = 0 for a wall
  std::vector<contact::Law> law;           ///< n−1 values
  std::vector<double> gap, velocity;       ///< at the start
  std::vector<double> gravity;             ///< n values; 0 for a wall
  double speed = 1;                        ///< reference speed: largest that can matter
  std::vector<double> reduced_mass;        ///< n−1 values; 1 between walls
  std::vector<double> length, time;        ///< n−1 natural lengths and times
  double slow = 0;                         ///< approach speed that cannot be told from rest
  std::vector<double> shallow;  ///< n−1 values: depth that a contact approached so slowly reaches
  double faint = 1;             ///< speed at which a contact fades, relative to slow
  double faint_depth = 1;       ///< depth at which it does, relative to shallow
  bool falls_back = false;      ///< gravity pulls some ball back to a wall
};

/// Speed that the balls of a validated chain can reach relative to each other: what they start with, and what
/// gravity and stored energy can add. The accuracy of velocities is relative to it.
double reference_speed(const Chain& chain);

/// Convert a validated chain into `d`, whose memory is reused. `accuracy` decides what is slow: a tenth
/// of what may be wrong anyway. Throws Unrepresentable.
void make_dimensionless(const Chain& chain, double accuracy, DimensionlessChain& d);

/// Let contacts fade as flows of a better accuracy can tell, so that what they leave behind is not an
/// approach that counts.
void fade_later(DimensionlessChain& d, double accuracy);

/// Balls `first` to `last` of a chain as a chain, in the same units and with the same speeds.
void copy_slice(const DimensionlessChain& whole, Index first, Index last, DimensionlessChain& slice);

}  // namespace mariotte::model
