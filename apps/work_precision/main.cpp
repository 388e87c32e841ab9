// Run time against error, beside rivals: figures, CSV and ratios.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "command_line/exit_code.hpp"
#include "command_line/program.hpp"
#include "command_line/terminal.hpp"
#include "friction_cost.hpp"
#include "lammps.hpp"
#include "lane_cost.hpp"
#include "law_cost.hpp"
#include "mariotte/report/page/files.hpp"
#include "measure.hpp"
#include "plots.hpp"
#include "ratios.hpp"
#include "slope_cost.hpp"

namespace mariotte::work_precision {
namespace {

using command::UsageError;

struct Options {
  std::vector<std::string> problems;
  std::vector<std::string> methods;
  std::string csv;
  std::string plots;
  bool quick = false;
  bool slopes = false;
  bool friction = false;
  bool laws = false;
  bool lammps = false;
  bool lanes = false;
  bool force = false;
};

/// A family of problems may be asked for by what stands before the dash.
bool is(const std::string& name, const std::string& wanted) {
  return name == wanted || name.starts_with(wanted + "-");
}

/// Those of `known` that are wanted, all if nothing is; throws UsageError for a name that means none.
template <class Thing, class NameOf>
std::vector<Thing> chosen(const std::vector<Thing>& known, const std::vector<std::string>& wanted,
                          const char* what, const NameOf& name_of) {
  if (wanted.empty()) return known;
  std::vector<std::string> names;
  for (const auto& thing : known) names.push_back(name_of(thing));
  for (const auto& name : wanted)
    if (std::none_of(names.begin(), names.end(), [&](const auto& one) { return is(one, name); }))
      throw UsageError(fmt::format("unknown {} '{}' (one of: {})", what, name, fmt::join(names, ", ")));
  std::vector<Thing> list;
  for (const auto& thing : known)
    if (std::any_of(wanted.begin(), wanted.end(), [&](const auto& name) { return is(name_of(thing), name); }))
      list.push_back(thing);
  return list;
}

std::vector<std::string> chosen_problems(const Options& options) {
  return chosen(problem_names(), options.problems, "problem", [](const auto& name) { return name; });
}

std::vector<Row> measure_all(const std::vector<std::string>& problems, const Options& options) {
  const auto effort = options.quick ? quick_effort() : full_effort();
  const auto list =
      chosen(methods(), options.methods, "method", [](const Method& method) { return method.name; });
  std::vector<Row> rows;
  for (const auto& name : problems) {
    const auto solved = problem(name, effort.map_stride);
    for (const auto& method : list) {
      std::fprintf(stderr, "%s by %s\n", name.c_str(), method.name.c_str());
      for (auto& row : measure(solved, method, effort)) rows.push_back(std::move(row));
    }
  }
  return rows;
}

/// Throws report::FileError for a file that exists, unless `force`.
void refuse_to_overwrite(const std::string& file, bool force) {
  if (!file.empty() && !force && std::filesystem::exists(file))
    throw report::FileError("cannot write " + file + ": it exists already (--force overwrites)",
                            fault::exists);
}

void draw(const Options& options, const std::vector<Row>& rows) {
  const auto shortfall = write_plots(options.plots, rows);
  if (!shortfall.empty()) command::warning("no figures: " + shortfall);
}

int run(const Options& options) {
  const auto patience = (options.quick ? quick_effort() : full_effort()).patience;
  if (options.slopes) command::print(slope_cost(patience));
  if (options.friction) command::print(friction_cost(patience));
  if (options.laws) command::print(law_cost(patience));
  if (options.lammps) command::print(beside_lammps(patience));
  if (options.lanes) command::print(lane_cost(patience));
  if (options.slopes || options.friction || options.laws || options.lammps || options.lanes)
    return command::ExitCode::ok;
  const auto names = chosen_problems(options);
  refuse_to_overwrite(options.csv, options.force);
  if (!options.plots.empty()) prepare_plots(options.plots, names, options.force);
  const auto rows = measure_all(names, options);
  if (!options.csv.empty()) report::write_file(options.csv, csv(rows));
  if (!options.plots.empty()) draw(options, rows);
  command::print(ratios(rows));
  if (const auto text = map_accuracy(rows); !text.empty()) command::print("\n" + text);
  return command::ExitCode::ok;
}

constexpr const char* examples = R"(Examples:
  work_precision --quick
  work_precision --problem P1 --problem P3 --method auto --method odeint-rkf78 --csv points.csv

A problem named without what follows its dash means all of them: P3 is P3-1, P3-1e4 and P3-1e8, and B is all
microbodies. Rivals with friction come in three kinds: -sgn, -smoothed over a slip of the tolerance or step times
the incident speed, and -smoothed-1e-3 over a thousandth of it.

Exit codes: 0 ok, 2 usage, 4 failure, 6 file error.
)";

command::OptionList declare(Options& options) {
  return {
      {"--problem", &options.problems, "Only this problem; may be repeated", {.value = "NAME"}},
      {"--method", &options.methods, "Only this method; may be repeated", {.value = "NAME"}},
      {"--quick", &options.quick, "Coarse ladders and short timings: all within a minute"},
      {"--slopes", &options.slopes,
       "Only what slopes of three balls and of rows cost, as multiples of a run"},
      {"--friction", &options.friction, "Only what bodies with friction cost, by series, CVODE and rivals"},
      {"--laws", &options.laws, "Only what a pair of each named law costs, and by CVODE"},
      {"--lammps", &options.lammps, "Only pairs of balls beside LAMMPS, if it is installed"},
      {"--lanes", &options.lanes, "Only what small impacts cost one by one, and many side by side"},
      {"--csv", &options.csv, "Write every point of the diagrams to this file", {.value = "FILE"}},
      {"--plots",
       &options.plots,
       "Draw run time against error, a figure per problem, in this folder",
       {.value = "DIR"}},
      {"--force", &options.force, "Overwrite files of an earlier run"}};
}

}  // namespace
}  // namespace mariotte::work_precision

int main(int argc, char** argv) {
  using namespace mariotte;
  work_precision::Options options;
  return command::run_program(
      {.name = "work_precision",
       .about = "Run time against error of mariotte and of its rivals, on impacts with known ends.",
       .footer = work_precision::examples,
       .options = work_precision::declare(options),
       .act = [&] { return work_precision::run(options); }},
      argc, argv);
}
