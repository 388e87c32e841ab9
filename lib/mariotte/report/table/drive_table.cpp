#include "mariotte/report/table/drive_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <cmath>
#include <numbers>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr std::array quantities{"position", "velocity", "force"};
constexpr std::array powers{"", " s", " s²", " s³"};

std::string number(double value) {
  return rounded(value, 10);
}

/// Adds a term to a sum, unless it is zero.
void add(double factor, const std::string& what, std::string& sum) {
  if (factor == 0) return;
  const bool first = sum.empty(), minus = factor < 0;
  sum += first ? (minus ? "-" : "") : (minus ? " - " : " + ");
  sum += number(std::abs(factor)) + what;
}

/// "0.1 sin(1000 · 2π t + 1.5)", "2 + 3 s", "0".
std::string formula(const SignalPiece& piece) {
  std::string angle, sum;
  add(piece.frequency / (2 * std::numbers::pi), " · 2π t", angle);
  add(piece.phase, "", angle);
  add(piece.amplitude, " sin(" + angle + ")", sum);
  for (std::size_t i = 0; i < powers.size(); ++i) add(piece.power[i], powers[i], sum);
  return sum.empty() ? "0" : sum;
}

/// "3", or "3 (0, 1)".
std::string moved(const ContactDirection& direction, Index dimension) {
  const Index place = direction.front().dof / dimension;
  if (dimension == 1) return fmt::format("{}", place + 1);
  std::vector<double> along(static_cast<std::size_t>(dimension));
  for (const auto& [dof, coefficient] : direction) along[dof % dimension] = coefficient;
  std::vector<std::string> components;
  for (const double one : along) components.push_back(number(one));
  return fmt::format("{} ({})", place + 1, fmt::join(components, ", "));
}

}  // namespace

std::string drive_table(const std::vector<model::Drive>& drives, const char* thing, Index dimension) {
  std::vector<TableRow> rows;
  for (std::size_t k = 0; k < drives.size(); ++k)
    for (const auto& piece : drives[k].signal.piece)
      rows.push_back({fmt::format("{}", k + 1), moved(drives[k].direction, dimension),
                      quantities[static_cast<std::size_t>(drives[k].quantity)], number(piece.start),
                      formula(piece)});
  if (rows.empty()) return "";
  const std::string name = dimension == 1 ? thing : fmt::format("{} (direction)", thing);
  return "\n" + columns({"drive", name, "quantity", "from [s]", "signal [SI], s = t - from"},
                        std::ssize(rows), [&](Index i) { return rows[static_cast<std::size_t>(i)]; });
}

}  // namespace mariotte::report
