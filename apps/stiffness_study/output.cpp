#include "output.hpp"

#include <fmt/format.h>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/number.hpp"

namespace mariotte::stiffness_study {
namespace {

using report::exact;

std::string first_icr(const Run& run) {
  if (run.icr.empty()) return "-";
  return run.icr[0] ? fmt::format("{:.12f}", *run.icr[0]) : "undefined";
}

report::TableRow cells(const Row& row) {
  const auto& run = row.run;
  const std::string value = fmt::format("{:g}", row.value);
  if (run.ending == "-" || run.ending == "failed") return {value, run.ending, "-", "-", "-", "-", "-"};
  return {value,
          fmt::format("{}", run.steps),
          fmt::format("{}", run.rhs),
          fmt::format("{:.4g}", 1e6 * run.seconds),
          row.error == row.error ? fmt::format("{:.1e}", row.error) : "-",
          first_icr(run),
          row.reference};
}

// The reason why some rows show "-", or the first failure.
std::string shortfall(const Rows& rows) {
  for (const auto& row : rows)
    if (!row.run.reason.empty()) return fmt::format("  from {:g}: {}\n", row.value, row.run.reason);
  return "";
}

std::string table_of(const Rows& rows) {
  const auto& first = rows.front();
  return fmt::format("\n{}, {}\n", first.series, first.flow) +
         report::columns({first.family, "steps", "rhs", "time [µs]", "error", "α₁", "reference"},
                         std::ssize(rows),
                         [&](Index i) { return cells(rows[static_cast<std::size_t>(i)]); }) +
         shortfall(rows);
}

// Text that may hold commas, quotes and line ends.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) result += c == '"' ? std::string("\"\"") : std::string(1, c == '\n' ? ' ' : c);
  return result + "\"";
}

std::string joined(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + exact(value);
  return text;
}

std::string joined(const std::vector<std::optional<double>>& values) {
  std::string text;
  for (const auto& value : values) text += (text.empty() ? "" : " ") + (value ? exact(*value) : "nan");
  return text;
}

std::string case_cells(const ImpactCase& one) {
  return fmt::format("{},{},{},{},{},{},{},{},{}", one.law, one.balls, exact(one.stiffness), exact(one.ratio),
                     exact(one.mass), exact(one.speed), exact(one.damping), exact(exponent(one)),
                     exact(damping_group(one)));
}

std::string csv_line(const Row& row) {
  const auto& run = row.run;
  std::string text = fmt::format("{},{},{},{},{},{},{},", row.study, quoted(row.series), quoted(row.family),
                                 case_cells(row.impact_case), row.flow, exact(row.accuracy), run.ending);
  text += fmt::format("{},{},", quoted(run.reason), fmt::join(run.flows, " "));
  text += run.ending == "-" ? ",,," : fmt::format("{},{},{},", run.steps, run.rhs, exact(run.seconds));
  text += (row.error == row.error ? exact(row.error) : "") + "," + row.reference + ",";
  return text + joined(run.icr) + "," + joined(run.instants) + "," + joined(run.velocity) + "\n";
}

}  // namespace

std::string table(const Rows& rows) {
  std::string text;
  for (std::size_t first = 0; first < rows.size();) {
    const auto same = [&](const Row& row) {
      return row.series == rows[first].series && row.family == rows[first].family &&
             row.flow == rows[first].flow;
    };
    std::size_t next = first + 1;
    while (next < rows.size() && same(rows[next])) ++next;
    text += table_of({rows.begin() + static_cast<Index>(first), rows.begin() + static_cast<Index>(next)});
    first = next;
  }
  return text;
}

std::string csv(const Rows& rows) {
  std::string text =
      "study,series,family,law,balls,stiffness [N/m^n],stiffness ratio,mass [kg],speed [m/s],"
      "damping [N s/m^n],exponent,damping group,flow,accuracy,ending,reason,followed by,steps,rhs,time "
      "[s],error,reference,"
      "icr,instants [T],velocities [v]\n";
  for (const auto& row : rows) text += csv_line(row);
  return text;
}

std::string text(const std::vector<Statement>& statements) {
  std::string text;
  for (const auto& one : statements) {
    const bool theorem = one.kind == Statement::Kind::theorem;
    text += fmt::format("{}: {}\n",
                        !theorem    ? "measured"
                        : one.holds ? "theorem holds"
                                    : "theorem FAILS",
                        one.text);
  }
  return text;
}

}  // namespace mariotte::stiffness_study
