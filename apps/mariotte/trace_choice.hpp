// `--trace` of `mariotte run`: what is sampled, how often, into which file.
#pragma once
#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "mariotte/report/trace_file.hpp"

namespace mariotte::command {

struct TraceChoice {
  std::string file;
  std::string every;
  std::string balls, contacts;
};

/// Declare --trace, --every, --balls and --contacts.
void add_trace_choice(CLI::App& command, TraceChoice& choice);

/// A trace on its way to its file; `sampling` feeds the file as long as this lives.
struct RunningTrace {
  impact::Sampling sampling;
  std::unique_ptr<report::TraceFile> file;
};

/// For a chain of so many balls; null if none was asked for. Throws UsageError or report::FileError.
std::unique_ptr<RunningTrace> start_trace(const TraceChoice& choice, std::size_t balls, bool force);

}  // namespace mariotte::command
