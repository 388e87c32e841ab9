#include "mariotte/report/table/restitution_table.hpp"

#include <fmt/format.h>

#include <array>

#include "mariotte/core/error.hpp"
#include "mariotte/report/csv/columns.hpp"

namespace mariotte::report {
namespace {

template <class Restitution>
std::string cell(Restitution&& restitution) try {
  return fmt::format("{:.8f}", restitution());
} catch (const InvalidParameter&) {
  return "–";
}

}  // namespace

std::string restitution_table(const std::string& thing, Index count, double speed,
                              const std::function<double(Index, double speed)>& restitution) {
  constexpr std::array factors = {0.1, 1.0, 10.0};
  if (!(speed > 0)) speed = 1;
  TableRow header = {thing};
  for (const double factor : factors) header.push_back(fmt::format("e at {:.4g} m/s", factor * speed));
  const auto row = [&](Index i) {
    TableRow cells = {fmt::format("{}", i + 1)};
    for (const double factor : factors) cells.push_back(cell([&] { return restitution(i, factor * speed); }));
    return cells;
  };
  return "\nRestitution of each " + thing + " alone, by the damping above\n" + columns(header, count, row);
}

}  // namespace mariotte::report
