// Whether double precision can carry a scene: masses, speeds, times, forces and energies from the start to
// the end.
#pragma once
#include <string_view>

#include "mariotte/core/error.hpp"
#include "mariotte/model/chain/dimensionless_chain.hpp"
#include "mariotte/model/fault.hpp"
#include "mariotte/model/microbody/dimensionless_microbody.hpp"
#include "mariotte/model/network/dimensionless_network.hpp"

namespace mariotte::model {

/// Sizes beyond these are not computed with; doubles end at 2.2e-308 and 1.8e308, and a run needs room for
/// sums, squares and the digits of small differences.
inline constexpr double smallest_size = 1e-290, largest_size = 1e290;

/// Damping group c/√(k m*) of a contact, at its natural indentation, beyond which nothing is computed: what
/// it still carries when its dampers have stopped it, ratio⁻² of what it began with, is rounding.
inline constexpr double largest_damping_group = 1e12;

/// Angle ω T of a drive within the shortest natural time of a contact beyond which nothing is computed: what
/// it moves within a period is rounding of the indentation.
inline constexpr double largest_driven_angle = 1e15;

/// A stated number, as scenes call it: "velocity", "mass", "stiffness" …
struct StatedNumber {
  std::string_view key = "velocity";
  Index place = -1;  ///< among the balls or contacts of a chain, from 0; −1 elsewhere
  double value = 0;
  Index drive = -1;  ///< of which it is, from 0; −1 of none
};

/// Numbers too large or too small for a run in double precision. `reason` is the one that is farthest from 1,
/// and so the likeliest.
struct Unrepresentable : InvalidParameter {
  Unrepresentable(const std::string& what, const StatedNumber& number)
      : InvalidParameter(what, fault::unrepresentable), reason(number) {}

  StatedNumber reason;
};

/// Throw Unrepresentable unless every size of the scaled model, and its units as numbers of the scene's
/// units, lie between smallest_size and largest_size: masses, lengths and times of contacts, stiffnesses; the
/// units of speed squared, force, momentum and energy; and unless speeds, gaps, damping, gravity, flight
/// times, energies and drives lie below largest_size, damping groups below largest_damping_group and angles
/// of drives below largest_driven_angle. A drive of the motion that is too small to square is no rest.
void expect_representable(const Chain& chain, const DimensionlessChain& scaled);
void expect_representable(const Network& network, const DimensionlessNetwork& scaled);
void expect_representable(const Microbody& body, const DimensionlessMicrobody& scaled);

/// The same of a validated model that has not been scaled yet.
void expect_representable(const Chain& chain);
void expect_representable(const Network& network);
void expect_representable(const Microbody& body);

}  // namespace mariotte::model
