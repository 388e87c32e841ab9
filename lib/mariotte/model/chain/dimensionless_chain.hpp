// A chain in units of order one.
#pragma once
#include <vector>

#include "mariotte/model/chain/chain.hpp"
#include "mariotte/model/contacts/scaled_contacts.hpp"

namespace mariotte::model {

/// The chain divided by `scale`. The reduced mass between walls is any.
struct DimensionlessChain : ScaledContacts {
  std::vector<double> mass, inverse_mass;  ///< n values; 1/∞ = 0 for a wall
  std::vector<double> gravity;             ///< n values; 0 for a wall
  bool falls_back = false;                 ///< gravity pulls some ball back to a wall
  /// By contact: its impulse is so small that momentum, summed up from the end on its side of the heaviest
  /// ball or from such a contact before, has too few digits for it.
  std::vector<char> is_faint;
};

/// The last of the heaviest, or the last wall: sums of momentum from both ends leave that one out.
Index heaviest_ball(const DimensionlessChain& chain);

/// Of a validated chain.
Speeds speeds(const Chain& chain);
inline double reference_speed(const Chain& chain) {
  return speeds(chain).reference;
}

/// Convert a validated chain into `d`, whose memory is reused. `accuracy` decides what is slow: a tenth
/// of what may be wrong anyway. Throws Unrepresentable.
void make_dimensionless(const Chain& chain, double accuracy, DimensionlessChain& d);

/// A chain with other numbers than the one `d` was made from, in the units of `d`.
void restate(const Chain& chain, DimensionlessChain& d);

/// Let contacts fade as flows of a better accuracy can tell, so that what they leave behind is not an
/// approach that counts.
void fade_later(DimensionlessChain& d, double accuracy);

/// Balls `first` to `last` of a chain as a chain, in the same units and with the same speeds.
void copy_slice(const DimensionlessChain& whole, Index first, Index last, DimensionlessChain& slice);

}  // namespace mariotte::model
