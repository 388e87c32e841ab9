// `--trace` of `mariotte run`: what is sampled, how often, into which file.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "command_line/declaration.hpp"
#include "mariotte/report/trace_file.hpp"

namespace mariotte::command {

struct TraceChoice {
  std::string file;
  std::string every;
  std::string balls, contacts;
};

/// --trace, --every, --balls and --contacts.
OptionList trace_options(TraceChoice& choice);

/// The files that it writes: none, or the trace and what describes it.
std::vector<std::filesystem::path> trace_files(const TraceChoice& choice);

/// A trace on its way to its file; `sampling` feeds the file as long as this lives.
struct RunningTrace {
  double every = 0;  ///< [s]; 0: the natural time
  impact::Sampling sampling;
  std::unique_ptr<report::TraceFile> file;
};

/// For a chain of so many balls; null if none was asked for. Throws UsageError or report::FileError.
std::unique_ptr<RunningTrace> start_trace(const TraceChoice& choice, std::size_t balls, bool force,
                                          const report::Attributes& origin);

}  // namespace mariotte::command
