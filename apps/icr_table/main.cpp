// Tables of impulse correlation ratios, for laws that are applied without a simulation.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "command_line/exit_code.hpp"
#include "command_line/program.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "family.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::icr_table {
namespace {

using command::UsageError;

struct CommandLine {
  ContactLaw law;
  std::map<std::string, std::string> ranges;  ///< by axis, as typed
  double accuracy = 1e-11;
  std::string out;
  bool force = false;
};

/// An axis of triplets: its name, what it is when it is not given, and what it sets.
struct Parameter {
  const char* name;
  const char* standard;
  const char* meaning;
  double Triplet::*value;
};
const std::vector<Parameter> parameters = {{"kappa", "1", "stiffness ratio k2/k1", &Triplet::kappa},
                                           {"mass-2", "1", "mass ratio m2/m1", &Triplet::mass_2},
                                           {"mass-3", "1", "mass ratio m3/m1", &Triplet::mass_3},
                                           {"v-3", "0", "velocity ratio v3/v1", &Triplet::v_3},
                                           {"damping", "0", "damping group of contact 1", &Triplet::damping}};

double number(const std::string& text) {
  const auto value = command::number(text);
  if (!value || !std::isfinite(*value)) throw UsageError("'" + text + "' is no number");
  return *value;
}

/// "X" or "FROM:TO:COUNT" with ":log" for equal ratios.
impact::TableAxis axis(const std::string& name, const std::string& range) {
  const auto parts = command::split(range, ':');
  if (parts.size() == 1) return {.name = name, .values = {number(range)}};
  const bool log = parts.size() == 4 && parts[3] == "log";
  if (parts.size() != 3 && !log) throw UsageError(name + ": write X, or FROM:TO:COUNT, or FROM:TO:COUNT:log");
  const double from = number(parts[0]), to = number(parts[1]), count = number(parts[2]);
  if (!(count >= 3) || count != std::floor(count) || count > 1e6)
    throw UsageError(name + ": an axis needs at least three values");
  if (!(from < to) || (log && !(from > 0)))
    throw UsageError(name + ": the range must rise, and be positive for log");
  impact::TableAxis axis{
      .name = name,
      .spacing = log ? impact::TableAxis::Spacing::log : impact::TableAxis::Spacing::linear,
      .values = {}};
  for (int i = 0; i < static_cast<int>(count); ++i) {
    const double share = i / (count - 1);
    axis.values.push_back(log ? from * std::pow(to / from, share) : from + share * (to - from));
  }
  axis.values.back() = to;
  return axis;
}

std::string law_text(const CommandLine& line) {
  const auto& law = line.law;
  return law.name == "viscoelastic" ? fmt::format("viscoelastic n = {:g}", law.exponent) : law.name;
}

impact::IcrTable triplets(const CommandLine& line) {
  impact::IcrTable table{
      .about = law_text(line) + " triplets, v = (1, 0, v-3), m1 = k1 = 1, c/k of both contacts equal",
      .accuracy = line.accuracy,
      .axis = {},
      .point = {}};
  Index points = 1;
  for (const auto& p : parameters) {
    const auto given = line.ranges.find(p.name);
    table.axis.push_back(axis(p.name, given == line.ranges.end() ? p.standard : given->second));
    points *= std::ssize(table.axis.back().values);
  }
  for (Index i = 0; i < points; ++i) {
    Triplet triplet;
    Index rest = i;
    for (std::size_t a = parameters.size(); a-- > 0;) {
      const auto& values = table.axis[a].values;
      triplet.*parameters[a].value = values[rest % std::ssize(values)];
      rest /= std::ssize(values);
    }
    table.point.push_back(simulate(chain(triplet, line.law), line.accuracy));
  }
  return table;
}

impact::IcrTable rows(const CommandLine& line, const std::string& range) {
  const auto parts = command::split(range, ':');
  const double from = number(parts.front()), to = number(parts.back());
  if (parts.size() > 2 || !(from >= 2 && to >= from && to <= 1e5) || from != std::floor(from))
    throw UsageError("balls: write N, or FROM:TO with at least 2 balls");
  const auto given = line.ranges.find("damping");
  const double damping = given == line.ranges.end() ? 0 : number(given->second);
  impact::IcrTable table{
      .about =
          fmt::format("{} rows of equal balls, v = (1, 0, …), damping group {:g}", law_text(line), damping),
      .accuracy = line.accuracy,
      .axis = {{.name = "balls", .spacing = impact::TableAxis::Spacing::exact, .values = {}}},
      .point = {}};
  for (Index n = static_cast<Index>(from); n <= static_cast<Index>(to); ++n) {
    table.axis[0].values.push_back(static_cast<double>(n));
    table.point.push_back(simulate(row(n, damping, line.law), line.accuracy));
  }
  return table;
}

constexpr const char* notes = R"(
Each point is simulated; the table holds the shares of the contacts in the impulse (their direction) and the
energy ratio relative to the mass centre. mariotte law --table FILE applies the law between the points.

Examples:
  icr_table --kappa 0.1:10:41:log --out kappa.csv
  icr_table --kappa 0.1:10:21:log --v-3 -1:0:21 --law linear --out plane.csv
  icr_table --damping 0:2:41 --law viscoelastic --exponent 1.5 --out damped.csv
  icr_table --balls 3:21 --out rows.csv

Exit codes: 0 ok, 2 usage, 4 solver failure, 6 file error.
)";

command::OptionList declare(CommandLine& line) {
  command::OptionList axes;
  for (const auto& p : parameters)
    axes.push_back({std::string("--") + p.name, &line.ranges[p.name], p.meaning, {.value = "RANGE"}});
  return command::joined(
      {{{"--law",
         &line.law.name,
         "linear, hertz or viscoelastic",
         {.check = command::OneOf{{"linear", "hertz", "viscoelastic"}}, .shows_default = true}},
        {"--exponent", &line.law.exponent, "n of viscoelastic contacts", {.check = command::Range{1, 100}}}},
       axes,
       {{"--balls", &line.ranges["balls"], "Rows of N equal balls instead of triplets", {.value = "N[:N]"}},
        {"--accuracy", &line.accuracy, "Accuracy of the simulations", {.check = command::is_accuracy}},
        {"--out",
         &line.out,
         "File to write; standard output without",
         {.value = "FILE", .check = command::is_file_name}},
        {"--force", &line.force, "Overwrite the file", {.needs = {"--out"}}}}});
}

std::string table(const CommandLine& line) {
  const auto balls = line.ranges.find("balls");
  if (balls == line.ranges.end()) return impact::write(triplets(line));
  if (line.ranges.size() > 1 + line.ranges.count("damping"))
    throw UsageError("--balls goes with --damping only");
  return impact::write(rows(line, balls->second));
}

int act(CommandLine& line) {
  std::erase_if(line.ranges, [](const auto& range) { return range.second.empty(); });
  if (!line.out.empty() && !line.force && std::filesystem::exists(line.out))
    throw report::FileError(line.out + " exists (--force overwrites it)", fault::exists);
  try {
    const auto text = table(line);
    line.out.empty() ? command::print(text) : report::write_file(line.out, text);
  } catch (const InvalidParameter& problem) {
    throw UsageError(problem.what());
  }
  return command::ExitCode::ok;
}

}  // namespace
}  // namespace mariotte::icr_table

int main(int argc, char** argv) {
  using namespace mariotte;
  icr_table::CommandLine line;
  return command::run_program({.name = "icr_table",
                               .about = "Impulse correlation ratios and energy ratios on a grid of impacts.",
                               .footer = icr_table::notes,
                               .options = icr_table::declare(line),
                               .act = [&] { return icr_table::act(line); }},
                              argc, argv);
}
