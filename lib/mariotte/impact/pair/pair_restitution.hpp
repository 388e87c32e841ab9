// Two bodies that meet alone: how much of their speed of approach they part with, and below which speed
// adhesion keeps them.
#pragma once
#include <optional>

#include "mariotte/contact/law.hpp"
#include "mariotte/impact/microbody/capture_velocity.hpp"

namespace mariotte::impact {

/// A contact between bodies that nothing else touches.
struct Pair {
  contact::Law law;
  double reduced_mass;  ///< m₁ m₂/(m₁ + m₂) [kg]
};

/// e of a pair that approaches at a speed [m/s], by simulation to the last digits; 0 if adhesion keeps it.
/// Throws InvalidParameter unless the speed is positive and finite, and Error if the run fails.
double restitution(const Pair& pair, double speed);

/// The same without integration: from energies for laws without a damper [Thornton 1997; Johnson, Kendall &
/// Roberts 1971], from the closed form of linear damped contacts [Schwager & Pöschel 2007], of Tsuji's, which
/// is the same [Antypov & Elliott 2011], and of Hunt and Crossley's. Empty for any other law.
std::optional<double> closed_restitution(const Pair& pair, double speed);

/// The speed below which the pair does not part again, found as that of a body; `guess` [m/s]. Empty if it
/// always does. Throws Error if a run fails.
std::optional<CaptureVelocity> capture_velocity(const Pair& pair, double guess, double tolerance);

}  // namespace mariotte::impact
