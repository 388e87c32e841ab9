// The flows that are chosen from; those of one series a step have headers of their own.
#pragma once
#include <memory>

#include "mariotte/flow/flow.hpp"
#include "mariotte/flow/kind.hpp"

namespace mariotte::flow {

/// Free flight: x(t) = x + t x' + t²/2 x'' up to the first crossing of a guard.
std::unique_ptr<Flow> make_ballistic_flow();
/// Free flight of bodies that know their own closed form: phases with a `free_motion()`.
std::unique_ptr<Flow> make_drift_flow();
/// Free flight of a symmetric body: phases with a `free_body()`.
std::unique_ptr<Flow> make_flight_flow();

/// One closed contact, everything else in free flight: closed form. Velocities follow from momentum, time
/// from quadrature. Other gaps are concave in time while the contact pushes, so the sign at the end of the
/// contact proves whether one of them closes before.
std::unique_ptr<Flow> make_pair_flow();

/// Linear contacts, damped or not: the motion is a sum of natural modes, nothing is integrated. Cost depends
/// neither on stiffness nor on damping groups; nothing is allocated after the first phase of a size. Admits
/// no phase with other contacts that act, nor where modes are so nearly alike that they cannot carry the
/// motion: within about 10⁻⁴ of critical damping of some mode, if the ratio of damping to stiffness is not
/// the same in all contacts that shake each other.
std::unique_ptr<Flow> make_modal_flow();

/// Taylor series of high order for contacts whose force is a sum of powers: rows of bodies, or contacts that
/// link degrees of freedom in any way. Expands the contacts that carry force, in time or in the clock
/// dt = √δ dσ of the contact that is about to let go, in which separation is an ordinary point. The
/// polynomial of a step is its dense output and the proof that no guard has fired within it. The order
/// follows from the accuracy.
std::unique_ptr<Flow> make_taylor_flow();

/// Taylor series for one tip of a symmetric body in contact with a plane: phases with a `tip()`. Those of
/// their motion, normal, planar or spatial, as far as the last coefficients allow. Guards are polynomials of
/// the step; that they keep their sign is proven, so no event is missed.
std::unique_ptr<Flow> make_tip_flow();

/// Taylor series of a recorded field: the explicit flow for phases of any shape. Expands everything that is
/// in contact in one clock: t = τ² where contacts begin, dt = √δ dσ of the contact that is nearest to its
/// beginning or end, else time. Guards are polynomials, and so certified.
std::unique_ptr<Flow> make_recorded_flow();

/// The general engine: CVODE with root-finding [Hindmarsh et al. 2005]. It follows any law. Adams (order ≤
/// 12) with fixed-point iteration, or BDF (order ≤ 5) with Newton on a dense, band or sparse matrix. Keeps
/// its memory between phases; made for problems of one size, pattern and number of guards.
std::unique_ptr<Flow> make_cvode_flow(Kind kind, const Problem& like);

}  // namespace mariotte::flow
