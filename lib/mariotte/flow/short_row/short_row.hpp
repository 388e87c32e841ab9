// Some bodies in a row with undamped Hertz contacts, of which many are followed side by side.
#pragma once
#include "mariotte/core/flights.hpp"

namespace mariotte::flow {

/// What a contact of a short row does.
enum class RowRole : signed char {
  open,
  touching,  ///< at rest since the start, or pressed since, too gently to push
  closed
};

/// What is next for a short row.
enum class RowStage : signed char {
  flight,  ///< no contact pushes
  pushes,  ///< some do: series
  over,    ///< none carries force and none comes together
  leaves   ///< something else than the common course: another solver has to do it
};

/// Dimensionless, in units in which all numbers are moderate; contact j is between bodies j and j+1.
struct ShortRow {
  static constexpr int most = 8;  ///< contacts

  int contacts = 0;
  double own[most] = {};         ///< k_j/m*_j: what the own δ^{3/2} takes from δ̈_j
  double from_left[most] = {};   ///< k_{j−1}/m_j: what that of the contact before gives to it
  double from_right[most] = {};  ///< k_{j+1}/m_{j+1}: what that of the contact behind gives
  double weight[most] = {};      ///< 1/√L of the natural lengths, roughly
  double acts_above[most] = {};  ///< δ below which a force is left out at the onset
  double noise_speed = 0;        ///< approach that cannot be told from rest
  double same_instant = 0;       ///< events closer than this are one
  double rate[most] = {};
  double indentation[most] = {};  ///< less than zero where open
  double time = 0;
  RowStage stage = RowStage::flight;
  RowRole role[most] = {};
  int periods[most] = {};
  int events = 0, steps = 0, series_steps = 0;
  Flights flights = {};
  double stride = 0;  ///< about the length of the steps before
};

/// A contact whose force is left out is heard again when it is so many times as deep as it may be without.
inline constexpr double heard_at = 3;

/// What is closed at the start, from gaps and rates; on to where something pushes, or to the end.
void begin(ShortRow& row);

/// A contact that touched pushes from now on.
void wake(ShortRow& row, int j);

/// A contact closes or lets go, at zero depth, while others may push; on to where something pushes, or to the
/// end.
void change(ShortRow& row, int j);

/// Some contact can be told neither from one that pushes nor from one that has let go.
bool has_faded(const ShortRow& row);

}  // namespace mariotte::flow
