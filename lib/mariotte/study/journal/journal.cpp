#include "mariotte/study/journal/journal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace mariotte::study {
namespace {

std::filesystem::path path_of(const std::filesystem::path& folder, Index rank) {
  return folder / (rank == 0 ? "journal.jsonl" : fmt::format("journal.{}.jsonl", rank));
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason,
                       Fault kind = fault::unreadable) {
  throw JournalError(path.string() + ": " + reason, kind);
}

/// Rows are lines.
std::string_view without_first(std::string_view rows, Index count) {
  for (; count > 0; --count) rows.remove_prefix(rows.find('\n') + 1);
  return rows;
}

}  // namespace

std::vector<std::filesystem::path> journals(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const auto name = entry.path().filename().string();
    if (name.starts_with("journal.") && name.ends_with(".jsonl")) paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

void remove_journals(const std::filesystem::path& folder) {
  for (const auto& path : journals(folder)) {
    const LockedFile file(path);
    std::error_code problem;
    std::filesystem::remove(path, problem);
    if (problem) fail(path, problem.message(), fault::unwritable);
  }
}

Journal::Journal(std::filesystem::path folder, std::string identity, Index points, Index rank,
                 std::chrono::milliseconds patience, Believes believes)
    : folder_(std::move(folder)),
      identity_(std::move(identity)),
      points_(points),
      believes_(std::move(believes)),
      file_(path_of(folder_, rank), patience) {
  reload();
}

/// Own and others' lines; the own file loses a torn end, and gets its heading if it has none.
void Journal::reload() {
  entries_.clear();
  paths_ = journals(folder_);
  for (const auto& path : paths_) {
    const std::size_t whole = scan(path);
    if (path != file_.path()) continue;
    file_.cut(whole);
    if (whole == 0) file_.append(heading_line(identity_, points_));
  }
}

bool Journal::counts(const Rows& rows) const {
  return rows.first >= 0 && rows.count >= 0 && rows.count <= points_ - rows.first &&
         (!believes_ || believes_(rows));
}

/// Size of the file up to its last whole line.
std::size_t Journal::scan(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::string line;
  std::size_t offset = 0;
  const auto file = static_cast<std::size_t>(std::find(paths_.begin(), paths_.end(), path) - paths_.begin());
  const auto heading = heading_line(identity_, points_);
  const auto expect = [&](bool own) {
    if (!own)
      fail(path,
           "belongs to another sweep: the scene, its overrides, columns or the program have changed "
           "(--force starts anew)",
           fault::foreign_journal);
  };
  while (std::getline(stream, line) && !stream.eof()) {
    if (offset == 0 && !is_heading(line))
      fail(path, "the first line, which says what is swept, is damaged (--force starts anew)");
    if (offset == 0) expect(line + "\n" == heading);
    if (const auto rows = read_rows(line); rows && counts(*rows))
      entries_.push_back({file, offset, line.size(), {rows->first, rows->count}, rows->failed});
    offset += line.size() + 1;
  }
  if (offset == 0) expect(heading.starts_with(line));
  if (stream.bad() || !stream.is_open()) fail(path, "cannot be read");
  return offset;
}

std::vector<PointRange> Journal::missing() const {
  std::vector<PointRange> done;
  for (const auto& entry : entries_) done.push_back(entry.points);
  return study::missing(std::move(done), points_);
}

Index Journal::failed() const {
  Index sum = 0;
  for (const auto& entry : entries_) sum += entry.failed;
  return sum;
}

void Journal::append(const Rows& rows) {
  const auto line = rows_line(rows);
  const std::lock_guard lock(writing_);
  const auto offset = file_.append(line);
  const auto number = std::find(paths_.begin(), paths_.end(), file_.path()) - paths_.begin();
  entries_.push_back(
      {static_cast<std::size_t>(number), offset, line.size() - 1, {rows.first, rows.count}, rows.failed});
}

void Journal::flush() {
  file_.flush();
}

void Journal::read(const std::function<void(Index, std::string_view)>& take) {
  if (!missing().empty()) fail(folder_, "the journal is not complete");
  std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
    return std::pair(a.points.first, -a.points.count) < std::pair(b.points.first, -b.points.count);
  });
  std::vector<std::ifstream> streams;
  for (const auto& path : paths_) streams.emplace_back(path, std::ios::binary);
  std::string line;
  Index next = 0;
  for (const auto& entry : entries_) {
    if (entry.points.first + entry.points.count <= next) continue;  // computed twice
    line.resize(entry.size);
    streams[entry.file].seekg(static_cast<std::streamoff>(entry.offset));
    streams[entry.file].read(line.data(), static_cast<std::streamsize>(line.size()));
    const auto rows = read_rows(line);
    if (!rows || rows->first != entry.points.first || rows->count != entry.points.count)
      fail(paths_[entry.file], "has changed while it was read");
    take(next, without_first(rows->text, next - rows->first));
    next = rows->first + rows->count;
  }
}

}  // namespace mariotte::study
