#include "mariotte/flow/short_row/short_row.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/types.hpp"
#include "mariotte/flow/pair/pair_motion.hpp"

namespace mariotte::flow {
namespace {

/// Balls that rattle for longer are not of the common course.
constexpr int most_periods = 15;

bool is_pressed(const ShortRow& row, int j) {
  return row.role[j] == RowRole::touching && (row.rate[j] != 0 || row.indentation[j] != 0);
}
/// It carries force, or is about to.
bool pushes(const ShortRow& row, int j) {
  return row.role[j] == RowRole::closed || is_pressed(row, j);
}
/// The series know its force.
bool is_heard(const ShortRow& row, int j) {
  return row.role[j] == RowRole::closed &&
         (row.indentation[j] > row.acts_above[j] || row.indentation[j] == 0 || row.rate[j] < 0);
}

template <class Which>
bool any(const ShortRow& row, Which&& which) {
  for (int j = 0; j < row.contacts; ++j)
    if (which(row, j)) return true;
  return false;
}

void start_period(ShortRow& row, int j) {
  row.flights.begin(row.time);
  row.role[j] = RowRole::closed;
  if (++row.periods[j] > most_periods) row.stage = RowStage::leaves;
}

void close(ShortRow& row, int j) {
  if (!(row.rate[j] > row.noise_speed)) row.stage = RowStage::leaves;
  start_period(row, j);
  row.indentation[j] = 0;
}

void let_go(ShortRow& row, int j) {
  if (!(row.rate[j] < 0)) row.stage = RowStage::leaves;
  row.flights.end(row.time);
  row.role[j] = RowRole::open;
  row.indentation[j] = 0;
}

/// Another one that closes or lets go at the same instant.
bool is_near(const ShortRow& row, int j) {
  const double depth = row.indentation[j], rate = row.rate[j];
  if (row.role[j] == RowRole::open) return rate > 0 && -depth <= rate * row.same_instant;
  return row.role[j] == RowRole::closed && rate < 0 && depth <= -rate * row.same_instant;
}

/// One that comes together too slowly to be told from rest, for long.
bool has_slipped_in(const ShortRow& row, int j) {
  return row.role[j] == RowRole::open && row.indentation[j] > 0;
}

void leave_if_unclear(ShortRow& row) {
  if (any(row, is_near) || any(row, has_slipped_in)) row.stage = RowStage::leaves;
}

/// How much of what contact c does to itself it does to its neighbour j, the other way round.
double share(const ShortRow& row, int c, int j) {
  return (j == c - 1 ? row.from_right[j] : j == c + 1 ? row.from_left[j] : 0) / row.own[c];
}

/// The only contact that pushes; −1 if there are several, or neighbours that touch.
int alone(const ShortRow& row) {
  int found = -1;
  for (int j = 0; j < row.contacts; ++j) {
    if (!pushes(row, j)) continue;
    if (found >= 0) return -1;
    found = j;
  }
  const auto touches = [&](int j) { return j >= 0 && j < row.contacts && row.role[j] == RowRole::touching; };
  return touches(found - 1) || touches(found + 1) ? -1 : found;
}

/// Contact c pushes alone until it lets go, which has a closed form, unless another one closes before.
bool ends_alone(ShortRow& row, int c) {
  const double depth = row.indentation[c], rate = row.rate[c];
  const HertzMotion motion({.stiffness = row.own[c], .damping = 0, .exponent = 1.5, .reduced_mass = 1},
                           {depth, rate});
  const auto [time, end] = motion.opening();
  double after[ShortRow::most];
  for (int j = 0; j < row.contacts; ++j) {
    const double part = share(row, c, j);
    after[j] = row.indentation[j] + (row.rate[j] + part * rate) * time + part * depth;
    if (j != c && row.role[j] == RowRole::open && after[j] > 0) return false;
  }
  for (int j = 0; j < row.contacts; ++j) {
    if (j == c || row.role[j] != RowRole::open) continue;
    row.indentation[j] = after[j];
    row.rate[j] += share(row, c, j) * (rate - end.rate);
  }
  row.rate[c] = end.rate;
  row.time += time;
  ++row.steps;
  ++row.events;
  let_go(row, c);
  leave_if_unclear(row);
  return true;
}

/// To where a contact closes, or to the end.
void fly(ShortRow& row) {
  int first = -1;
  double soonest = infinity;
  for (int j = 0; j < row.contacts; ++j) {
    if (row.role[j] != RowRole::open || !(row.rate[j] > row.noise_speed)) continue;
    const double meets = -row.indentation[j] / row.rate[j];
    if (meets < soonest) soonest = meets, first = j;
  }
  if (first < 0) {
    row.stage = RowStage::over;
    return;
  }
  for (int j = 0; j < row.contacts; ++j)
    if (row.role[j] == RowRole::open) row.indentation[j] += soonest * row.rate[j];
  row.time += soonest;
  ++row.steps;
  ++row.events;
  close(row, first);
  leave_if_unclear(row);
}

/// By closed forms to where series are needed, or to the end.
void go_on(ShortRow& row) {
  row.stage = RowStage::flight;
  while (row.stage == RowStage::flight) {
    if (!any(row, pushes)) {
      fly(row);
    } else if (const int c = alone(row); c < 0 || !ends_alone(row, c)) {
      row.stage = any(row, is_heard) ? RowStage::pushes : RowStage::leaves;
    }
  }
}

}  // namespace

bool has_faded(const ShortRow& row) {
  return any(row, [](const ShortRow& r, int j) {
    const bool can_be_told =
        r.indentation[j] > r.acts_above[j] || r.rate[j] > 0 || -r.rate[j] > r.noise_speed;
    return r.role[j] == RowRole::closed && !can_be_told;  // so is one that is no number
  });
}

void begin(ShortRow& row) {
  for (int j = 0; j < row.contacts; ++j)
    if (row.indentation[j] == 0 && row.rate[j] == 0) row.role[j] = RowRole::touching;
  for (int j = 0; j < row.contacts; ++j) {
    if (row.indentation[j] != 0 || !(row.rate[j] > 0)) continue;
    row.events = 1;
    close(row, j);
  }
  if (row.stage != RowStage::leaves) go_on(row);
}

void wake(ShortRow& row, int j) {
  if (row.role[j] == RowRole::touching) start_period(row, j);
}

void change(ShortRow& row, int j) {
  ++row.events;
  row.role[j] == RowRole::open ? close(row, j) : let_go(row, j);
  leave_if_unclear(row);
  if (row.stage != RowStage::leaves) go_on(row);
}

}  // namespace mariotte::flow
