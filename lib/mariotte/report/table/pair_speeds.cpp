#include "mariotte/report/table/pair_speeds.hpp"

#include <fmt/format.h>

#include <vector>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {

std::string pair_table(const impact::MeetingSpeeds& speeds, std::size_t periods) {
  const auto [approach, separation] = speeds;
  if (periods != 1 || !approach || !(*approach > 0) || !separation) return "";
  const auto display = display_for(std::vector{*approach, *separation}, "m/s");
  return "\nPair\n" + line("approach [" + display.unit + "]", shown(display, *approach)) +
         line("separation [" + display.unit + "]", shown(display, *separation)) +
         line("restitution", fixed(*separation / *approach, 10));
}

}  // namespace mariotte::report
