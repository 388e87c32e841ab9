#include "mariotte/report/csv/sweep_rows.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/reached_limit.hpp"
#include "mariotte/impact/doubt.hpp"
#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/csv/sweep_csv.hpp"
#include "mariotte/study/sweep/evaluate.hpp"

namespace mariotte::report {
namespace {

bool is_ending(std::string_view word) {
  constexpr auto last = static_cast<int>(hybrid::Ending::failed);
  for (int number = 0; number <= last; ++number)
    if (word == hybrid::name(static_cast<hybrid::Ending>(number))) return true;
  return word == "rejected";
}

/// Of the lines of one batch.
class Reader {
 public:
  Reader(const study::Design& design, std::size_t columns) : design_(design), columns_(columns) {}

  bool is_row(std::string_view line, Index point) {
    expected_.clear();
    append_parameters(design_, point, expected_);
    if (!line.starts_with(expected_)) return false;
    split(line.substr(expected_.size()), cells_);
    if (cells_.size() != columns_ + 2 || !is_ending(cells_[columns_])) return false;
    const bool has_numbers = study::Verdict{.ending = cells_[columns_]}.has_numbers();
    failed_ += !has_numbers;
    const auto fits = [&](const std::string& cell) {
      return cell.empty() || (has_numbers && !std::isnan(number(cell)));
    };
    return std::all_of(cells_.begin(), cells_.begin() + static_cast<std::ptrdiff_t>(columns_), fits) &&
           (has_numbers || !cells_.back().empty());
  }
  Index failed() const { return failed_; }

 private:
  const study::Design& design_;
  std::size_t columns_;
  std::string expected_;
  std::vector<std::string> cells_;
  Index failed_ = 0;
};

Index count_lines(std::string_view rows, bool (*tells)(std::string_view)) {
  Index count = 0;
  for (; !rows.empty(); rows.remove_prefix(rows.find('\n') + 1))
    count += tells(rows.substr(0, rows.find('\n')));
  return count;
}

}  // namespace

bool are_rows_of(const study::Design& design, std::size_t columns, const study::Rows& rows) {
  Reader reader(design, columns);
  std::string_view rest = rows.text;
  for (Index k = 0; k < rows.count; ++k) {
    const auto end = rest.find('\n');
    if (end == std::string_view::npos || !reader.is_row(rest.substr(0, end), rows.first + k)) return false;
    rest.remove_prefix(end + 1);
  }
  return rest.empty() && reader.failed() == rows.failed;
}

Index count_limited(std::string_view rows) {
  return count_lines(rows, hybrid::tells_limit);
}

Index count_doubtful(std::string_view rows) {
  return count_lines(rows, impact::tells_doubt);
}

}  // namespace mariotte::report
