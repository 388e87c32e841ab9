// How cost and results depend on stiffness: tables, CSV, figures, and what they prove.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

#include "mariotte/core/error.hpp"
#include "mariotte/flow/choose.hpp"
#include "mariotte/report/files.hpp"
#include "output.hpp"

namespace mariotte::stiffness_study {
namespace {

enum ExitCode : int { ok = 0, theorem_failed = 1, usage = 2, solver_failed = 4, bad_file = 6 };

struct CommandLine {
  Settings settings;
  std::vector<std::string> studies;
  std::string csv;
  std::string plots;
};

void print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw report::FileError("cannot write to standard output");
}

int fail(const std::string& message, ExitCode code) {
  std::fprintf(stderr, "stiffness_study: error: %s\n", message.c_str());
  return code;
}

std::string is_flow(const std::string& text) {
  try {
    flow::parse_kind(text);
    return "";
  } catch (const InvalidParameter& problem) {
    return problem.what();
  }
}

std::string is_study(const std::string& text) {
  std::string known;
  for (const auto& study : studies()) {
    if (study.name == text) return "";
    known += (known.empty() ? "" : ", ") + study.name;
  }
  return "unknown study '" + text + "' (one of: " + known + ")";
}

std::string is_accuracy(const std::string& text) {
  double value = 0;
  return CLI::detail::lexical_cast(text, value) && value > 0 && value < 1
             ? ""
             : "must be a number between 0 and 1";
}

constexpr const char* notes = R"(
Every run gets raw SI numbers. Errors are those of final velocities relative to the incident speed; times are
CPU time, the least of repeated batches. "-" marks flows that had become too slow.

Examples:
  stiffness_study --quick
  stiffness_study --csv study.csv --plots figures
  stiffness_study --study ratio --flow modal --accuracy 1e-12
  stiffness_study --study crossover

Exit codes: 0 ok, 1 a theorem failed, 2 usage, 4 solver failure, 6 file error.
)";

void declare(CLI::App& app, CommandLine& line) {
  app.footer(notes);
  app.add_option(
         "--study", line.studies,
         "stiffness, ratio, damping, scaling or crossover; may be repeated (default: all but crossover)")
      ->allow_extra_args(false)
      ->check(is_study, "");
  app.add_option("--flow", line.settings.flow, "Only this flow")->check(is_flow, "");
  app.add_option("--accuracy", line.settings.accuracy,
                 "Wanted error of the final velocities / incident speed")
      ->check(is_accuracy, "")
      ->capture_default_str();
  app.add_option("--csv", line.csv, "Write every run into this file")->type_name("FILE");
  app.add_option("--plots", line.plots, "Write figures, their data and script into this folder")
      ->type_name("DIR");
  app.add_flag("--quick", line.settings.quick, "Few values, rough times: seconds instead of minutes");
}

bool wanted(const CommandLine& line, const Study& study) {
  if (line.studies.empty()) return study.by_default;
  return std::find(line.studies.begin(), line.studies.end(), study.name) != line.studies.end();
}

Findings run(const CommandLine& line) {
  Findings all;
  for (const auto& study : studies()) {
    if (!wanted(line, study)) continue;
    auto found = study.run(line.settings);
    print(fmt::format("{}══ {}\n{}", all.rows.empty() ? "" : "\n", study.title, table(found.rows)));
    add(all.rows, std::move(found.rows));
    for (auto& one : found.statements)
      all.statements.push_back({one.kind, study.name + ": " + one.text, one.holds});
    all.figures.insert(all.figures.end(), found.figures.begin(), found.figures.end());
  }
  return all;
}

int act(const CommandLine& line) {
  const auto findings = run(line);
  print("\n══ What was found\n" + text(findings.statements));
  if (!line.csv.empty()) report::write_file(line.csv, csv(findings.rows));
  if (!line.plots.empty())
    if (const auto why = draw(line.plots, findings.figures); !why.empty())
      std::fprintf(stderr, "stiffness_study: warning: no figures: %s\n", why.c_str());
  const bool holds =
      std::all_of(findings.statements.begin(), findings.statements.end(),
                  [](const Statement& one) { return one.kind != Statement::Kind::theorem || one.holds; });
  return holds ? ExitCode::ok : ExitCode::theorem_failed;
}

int command_line(int argc, char** argv) {
  CLI::App app("How cost and results of impacts depend on stiffness, stiffness ratio and damping.",
               "stiffness_study");
  CommandLine line;
  declare(app, line);
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    print(app.help());
    return ExitCode::ok;
  } catch (const CLI::ParseError& problem) {
    return fail(std::string(problem.what()) + " (see --help)", ExitCode::usage);
  }
  return act(line);
}

}  // namespace
}  // namespace mariotte::stiffness_study

int main(int argc, char** argv) {
  using namespace mariotte;
  try {
    return stiffness_study::command_line(argc, argv);
  } catch (const report::FileError& problem) {
    return stiffness_study::fail(problem.what(), stiffness_study::bad_file);
  } catch (const std::exception& problem) {
    return stiffness_study::fail(problem.what(), stiffness_study::solver_failed);
  }
}
