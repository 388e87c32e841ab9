// Three bodies in a row with two undamped Hertz contacts, of which many are followed side by side.
#pragma once
#include "mariotte/core/flights.hpp"
#include "mariotte/flow/pair/indentation.hpp"

namespace mariotte::flow {

/// What is next for a triplet.
enum class TripletStage : signed char {
  flight,   ///< no contact is closed
  alone,    ///< one is closed
  meets,    ///< one is closed, and the other one closes before it lets go
  struck,   ///< both start undeformed, struck together
  pressed,  ///< one is struck, the other touches at rest
  both,     ///< both are closed: series
  over,     ///< no contact carries force and none comes together
  leaves    ///< something else than the common course: another solver has to do it
};

/// Dimensionless, in units in which all numbers are moderate; contacts 0 and 1 from left to right.
struct Triplet {
  double own[2];        ///< k_j/m*_j: what the own δ^{3/2} takes from δ̈_j
  double cross[2];      ///< k_i/m: what that of the other contact i gives to it
  double weight[2];     ///< 1/√L of the natural lengths, roughly
  double noise_speed;   ///< approach that cannot be told from rest
  double noise_root;    ///< √(δ/L) that such an approach reaches, or more
  double same_instant;  ///< events closer than this are one
  double rate[2];
  double indentation[2] = {};  ///< less than zero where open
  double time = 0;
  TripletStage stage = TripletStage::flight;
  bool closed[2] = {};
  int striker = 0;  ///< the contact that is struck, where the other is pressed
  int periods[2] = {};
  int events = 0, steps = 0, series_steps = 0;
  Flights flights = {};
};

/// Closes contact j, which comes to zero depth with a rate above zero, and says what is next.
void close(Triplet& triplet, int j);

/// What is closed at the start, from gaps and rates.
void begin(Triplet& triplet);

/// Both contacts are closed since they started undeformed a time ago, if that is certain.
void begin_series(Triplet& triplet, double time, bool is_certain);

/// Contact j lets go after both have been closed; the triplet leaves if j is −1.
void let_go(Triplet& triplet, int j);

/// The contact that pushes alone lets go after a time, if the other one has not closed by then.
void end_pair(Triplet& triplet, double time, const Indentation& pushing, const Indentation& other);

/// From the stage `meets` to where both are closed.
void meet(Triplet* triplet);

/// From the stage `flight` to where a contact closes, or to the end.
void fly(Triplet* triplet);

}  // namespace mariotte::flow
