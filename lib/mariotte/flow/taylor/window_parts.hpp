// What the windows of rows and of networks are made of.
#pragma once
#include "mariotte/flow/taylor/felt.hpp"
#include "mariotte/flow/taylor/taylor_window.hpp"

namespace mariotte::flow::taylor {

/// Depth below which the force of a contact is left out: within the depth that cannot be told from rounding,
/// less for what damping adds to the force. Laws without a branch point need none.
inline double wake_depth(const PhaseContact& contact, double speed) {
  if (contact.exponent == 1) return -infinity;
  if (contact.pull > 0 || contact.ring > 0) return 0;  // it pulls from the start
  return 0.5 * contact.noise_depth / (1 + contact.damping_share(speed));
}

/// A contact whose force is left out may sink so many times as deep as where it wakes before it is heard: it
/// stores the same share of what it does at its end for all powers.
inline double lateness(const PhaseContact& contact) {
  constexpr double of_hertz = 5;
  return contact.exponent <= 1.5 ? of_hertz : std::pow(of_hertz, 2.5 / (contact.exponent + 1));
}

/// The segment of its curve that a contact is on. One that touched and is drawn apart has no force: its first
/// cubic may be narrow, and says nothing below zero: it is on one without width.
inline const CubicSegment& segment_of(const PhaseContact& contact, double indentation) {
  static constexpr CubicSegment apart{.from = 0, .to = 0, .a = {}};
  return indentation < 0 ? apart : segment_at(*contact.curve, indentation);
}

/// A closed contact at its onset, where rounding may have left it beside zero.
inline bool is_onset(const PhaseContact& contact, double indentation) {
  return contact.role == Role::closed && indentation <= 16 * epsilon * contact.length;
}

/// Place the window over a row; around what moves or pushes unless it is driven.
void place(Window& window, const SerialPhase& phase, State x, double time);
/// Over linked contacts.
void place(Window& window, const LinkedPhase& phase, State x, double time);
/// A contact at the edge is about to push on a body outside.
bool has_outgrown_row(const Window& window);
bool has_outgrown_network(const Window& window);
/// What drives do to its lanes and velocities, and when the first has a kink.
void begin_drives(Window& window);

/// What a contact that pushes stores, but for what the series count as work: all of it without dampers.
double stored_energy(const Window& window, int lane, double indentation);

/// Make one lane for each of `contacts`.
void begin(Window& window);

/// A contact outside, of an indentation that changes by a rate and an acceleration.
void add_loose(Window& window, const PhaseContact& contact, double rate, double acceleration);

/// Fill a lane from its contact, which has the rate δ̇, and the window's state.
void fill(Window& window, int lane, double rate);

/// Once all lanes are filled and linked: what pulls drives all that feel it.
void settle(Window& window);

/// Lanes do to each other what `coupling` says, which must last as long as they.
void link(Window& window, const Coupling& coupling);

/// Write what stands outside, `elapsed` after the window was placed, to x, which may be the window's own.
void write_outside(const Window& window, double elapsed, State x);
/// The velocities of the bodies of a row that fall there.
void write_falls(const Window& window, double elapsed, State x);

}  // namespace mariotte::flow::taylor
