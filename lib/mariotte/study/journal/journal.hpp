// What a sweep has finished, on disk: killed at any moment, it goes on where it was.
//
// Every process appends to a file of its own: journal.jsonl, journal.1.jsonl, … A line counts when it is
// there to its end, its checksum is right and its rows can be those of its points; what a kill has torn is
// computed again.
#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "mariotte/study/journal/journal_line.hpp"
#include "mariotte/study/journal/locked_file.hpp"
#include "mariotte/study/sweep/ranges.hpp"

namespace mariotte::study {

class Journal {
 public:
  /// Whether rows can be those of their points; what cannot is computed again.
  using Believes = std::function<bool(const Rows&)>;

  /// Opens the journal of `rank` in a folder, makes it if it is not there, and locks it; then reads those of
  /// all ranks. `identity` is what makes two sweeps the same. A process whose mpirun was killed lives on for
  /// a moment: `patience` is how long to wait until it lets go. Throws JournalError.
  Journal(std::filesystem::path folder, std::string identity, Index points, Index rank = 0,
          std::chrono::milliseconds patience = {}, Believes believes = {});

  /// Points without a result.
  std::vector<PointRange> missing() const;

  /// Points with a result that has no numbers.
  Index failed() const;

  /// Adds results; survives the end of this process at once. May be called by several threads.
  void append(const Rows& rows);

  /// Waits until what was appended is on the disk.
  void flush();

  /// Looks for what other processes have added.
  void reload();

  /// Hands over the rows of all points in their order, once none is missing: from which point on, and them.
  void read(const std::function<void(Index, std::string_view)>& take);

 private:
  struct Entry {
    std::size_t file;
    std::size_t offset, size;  ///< of the line, without its line break
    PointRange points;
    Index failed;
  };
  std::size_t scan(const std::filesystem::path& path);
  bool counts(const Rows& rows) const;

  std::filesystem::path folder_;
  std::string identity_;
  Index points_;
  Believes believes_;
  LockedFile file_;
  std::mutex writing_;
  std::vector<std::filesystem::path> paths_;
  std::vector<Entry> entries_;
};

/// The journals in a folder, of all ranks.
std::vector<std::filesystem::path> journals(const std::filesystem::path& folder);

/// Removes them. Throws JournalError if a sweep is writing one.
void remove_journals(const std::filesystem::path& folder);

}  // namespace mariotte::study
