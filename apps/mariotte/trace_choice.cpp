#include "trace_choice.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>

#include "command_line/exit_code.hpp"
#include "command_line/values.hpp"
#include "interruption.hpp"
#include "mariotte/report/csv/csv_metadata.hpp"
#include "mariotte/report/page/files.hpp"

namespace mariotte::command {
namespace {

/// A list of places, and the option that has it.
struct List {
  const char* option;
  std::string text;
};

[[noreturn]] void reject(const List& list, const std::string& why) {
  throw UsageError(fmt::format("{} {}: {}", list.option, list.text, why));
}

Index number(const std::string& text, const List& list, std::size_t count) {
  Index value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc() || stop != end || value < 1 || value > static_cast<Index>(count))
    reject(list, fmt::format("'{}' is no number from 1 to {}", text, count));
  return value;
}

/// "1,5,10:20,100:1000:50", from 1; the places from 0.
std::vector<Index> places(const List& list, std::size_t count) {
  std::vector<Index> found;
  std::vector<bool> is_named(count, false);
  for (const auto& part : split(list.text, ',')) {
    const auto range = split(part, ':');
    const Index from = number(range.front(), list, count);
    const Index to = range.size() > 1 ? number(range[1], list, count) : from;
    const Index step = range.size() > 2 ? number(range[2], list, count) : 1;
    if (range.size() > 3) reject(list, fmt::format("'{}': write N, FROM:TO or FROM:TO:STEP", part));
    if (from > to) reject(list, fmt::format("'{}' names nothing: it runs backwards", part));
    for (Index place = from; place <= to; place += step) {
      if (is_named[place - 1]) reject(list, fmt::format("{} stands in it twice", place));
      is_named[place - 1] = true;
      found.push_back(place - 1);
    }
  }
  return found;
}

std::string is_trace_name(const std::string& text) {
  const auto ending = std::filesystem::path(text).extension();
  const bool is_known = ending == ".csv" || ending == ".h5" || ending == ".hdf5";
  return is_known ? "" : fmt::format("'{}' does not end in .csv, .h5 or .hdf5", text);
}

double interval(const std::string& text) {
  return text.empty() ? 0 : positive_quantity("--every", text, dimension::time);
}

void expect_new(const std::string& file) {
  if (std::filesystem::exists(std::filesystem::symlink_status(file)))
    throw report::FileError("cannot write " + file + ": it exists already (--force overwrites)",
                            fault::exists);
}

/// Opens the file, once more for samples that come anew. The trace must stay where it is.
void feed(const std::string& name, const report::Attributes& origin, RunningTrace& trace) {
  const auto open = [&trace, name, origin] {
    trace.file.reset();
    trace.file = report::new_trace_file(name, trace.sampling.velocities, trace.sampling.contacts, origin);
  };
  open();
  trace.sampling.take = [&trace](const impact::Sample& sample) {
    trace.file->add(sample);
    if (interruption() != 0) return infinity;
    return trace.every > 0 ? trace.every : sample.natural_time;
  };
  trace.sampling.restart = open;
}

}  // namespace

OptionList trace_options(TraceChoice& choice) {
  return {{"--trace",
           &choice.file,
           "Write samples into this file as they come: CSV, or HDF5 if it ends in .h5 or .hdf5",
           {.value = "FILE", .check = is_trace_name}},
          {"--every",
           &choice.every,
           "Time between samples, such as \"1 us\" (default: natural time of the quickest contact)",
           {.value = "TIME", .needs = {"--trace"}}},
          {"--balls",
           &choice.balls,
           "Balls to trace, such as 1,5,10:20,100:1000:50 (default: all)",
           {.value = "LIST", .needs = {"--trace"}}},
          {"--contacts",
           &choice.contacts,
           "Contacts to trace (default: all)",
           {.value = "LIST", .needs = {"--trace"}}}};
}

std::vector<std::filesystem::path> trace_files(const TraceChoice& choice) {
  if (choice.file.empty()) return {};
  return {choice.file, report::metadata_name(choice.file)};
}

std::unique_ptr<RunningTrace> start_trace(const TraceChoice& choice, std::size_t balls, bool force,
                                          const report::Attributes& origin) {
  if (choice.file.empty()) return nullptr;
  const auto chosen = [](const char* option, const std::string& text, std::size_t count) {
    return places({option, text.empty() ? fmt::format("1:{}", count) : text}, count);
  };
  auto trace = std::make_unique<RunningTrace>();
  trace->sampling.velocities = chosen("--balls", choice.balls, balls);
  trace->sampling.contacts = chosen("--contacts", choice.contacts, balls - 1);
  trace->every = interval(choice.every);
  if (!force) expect_new(choice.file);
  feed(choice.file, origin, *trace);
  return trace;
}

}  // namespace mariotte::command
