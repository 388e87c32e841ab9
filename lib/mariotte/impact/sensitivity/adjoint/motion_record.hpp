// The motion of a row while contacts push, kept so that it can be read backwards.
//
// Steps are kept as values in the Gauss points of their pieces: the rate of the clock, and indentation and
// its rate of every contact that pushes. A clock u runs from 0 to 1 over a piece; the points resolve the
// stiffness of contacts in it.
#pragma once
#include <array>
#include <vector>

#include "mariotte/core/instant.hpp"
#include "mariotte/core/types.hpp"
#include "mariotte/impact/sensitivity/gauss.hpp"

namespace mariotte::impact {

/// Of something in each Gauss point.
using Nodes = std::array<double, stages>;

/// Its integral, if it is a rate.
inline double total(const Nodes& rate) {
  double sum = 0;
  for (int i = 0; i < stages; ++i) sum += gauss.weight[i] * rate[i];
  return sum;
}

/// Lists from the first to the last; each element says how many of the next list belong to it.
struct MotionRecord {
  /// Balls `first` to `last` between two events, the first of which was at `begin`; or a part of that.
  struct Stretch {
    Index first, last;
    Instant begin;
    Index part = 0;
    Instant start = begin, end = begin;
    Index pieces = 0, contacts = 0, rates = 0;
    Index closings = 0;  ///< contacts whose force begins with a jump at the start
  };
  struct Piece {
    Nodes pace;          ///< dt/du
    Index contacts = 0;  ///< that push
    Index shallow = 0;   ///< the last of them, which hardly do
  };
  struct Contact {
    Index number;
    Nodes depth;
    int rise = 0, fall = 0;  ///< δ begins and ends as powers of u and 1 − u
  };
  std::vector<Stretch> stretch;
  std::vector<Piece> piece;
  std::vector<Contact> contact;
  std::vector<Nodes> rate;  ///< of the contacts with a damper
  std::vector<Index> closing;

  std::size_t bytes() const;
};

/// Stretches `from` to `to` − 1.
MotionRecord part_of(const MotionRecord& motion, Index from, Index to);
void append(MotionRecord& motion, const MotionRecord& more);

}  // namespace mariotte::impact
