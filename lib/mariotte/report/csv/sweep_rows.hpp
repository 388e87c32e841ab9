// Whether rows of a sweep's journal are rows of this sweep.
#pragma once
#include <string_view>

#include "mariotte/study/journal/journal_line.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::report {

/// True if there is one line per point, each with the values that the design gives to its point, so many
/// columns that are numbers or empty, a known ending, and a reason if there are no numbers; and if the count
/// of points without numbers is right. A checksum tells what a disk has altered; this tells what another hand
/// has written.
bool are_rows_of(const study::Design& design, std::size_t columns, const study::Rows& rows);

/// How many of these lines, with their line breaks, tell of a limit that ended their run, or that velocities
/// are less exact than was asked.
Index count_limited(std::string_view rows);
Index count_doubtful(std::string_view rows);

}  // namespace mariotte::report
