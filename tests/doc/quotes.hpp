// What the documents quote, and when a quotation is true.
#pragma once
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace doc {

namespace fs = std::filesystem;
using Lines = std::vector<std::string>;

inline Lines lines_of(std::istream&& text) {
  Lines lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// A fenced block or a table, with the HTML comment that stands right before it.
struct Block {
  std::string place;     ///< "README.md:12"
  std::string language;  ///< after the fence; "table" for a table
  std::string comment;   ///< "file: apps/scenes/triplet.toml"; empty if there is none
  Lines text;
};

/// Blocks of one document; plain indented blocks are not among them.
inline std::vector<Block> blocks_of(const std::string& name, const Lines& lines) {
  std::vector<Block> blocks;
  std::string comment;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& line = lines[i];
    const bool fenced = line.starts_with("```"), table = line.starts_with("|");
    if (fenced || table) {
      Block block{name + ":" + std::to_string(i + 1), fenced ? line.substr(3) : "table", comment, {}};
      if (fenced) ++i;
      for (; i < lines.size() && (fenced ? lines[i] != "```" : lines[i].starts_with("|")); ++i)
        block.text.push_back(lines[i]);
      blocks.push_back(block);
      comment.clear();
    } else if (line.starts_with("<!-- ") && line.ends_with(" -->")) {
      comment = line.substr(5, line.size() - 9);
    } else if (!line.empty()) {
      comment.clear();
    }
  }
  return blocks;
}

/// How closely numbers of a quotation agree with those printed now.
enum class Numbers {
  digits,     ///< to 1e-6 of their size: rounding differs from machine to machine, results do not
  magnitudes  ///< the same, but those with an exponent, which are errors, within a factor of 10
};

inline bool agree(const std::string& quoted, const std::string& printed, Numbers numbers) {
  const double a = std::stod(quoted), b = std::stod(printed);
  const double larger = std::max(std::abs(a), std::abs(b)), smaller = std::min(std::abs(a), std::abs(b));
  if (numbers == Numbers::digits || quoted.find('e') == std::string::npos)
    return std::abs(a - b) <= 1e-6 * larger + 1e-9;
  return a * b >= 0 && larger <= 10 * smaller;
}

/// Words must be equal, whatever blanks are between them; numbers must agree. Residuals and the cost of an
/// integration are noise to their last digit, and only their words are compared.
inline bool same_line(const std::string& quoted, const std::string& printed, Numbers numbers) {
  static const std::regex number("[-+]?[0-9]+(\\.[0-9]+)?([eE][-+]?[0-9]+)?"), blanks("[ \t]+");
  const auto words = [&](const std::string& line) {
    return std::regex_replace(std::regex_replace(line, number, "#"), blanks, " ");
  };
  if (words(quoted) != words(printed)) return false;
  if (quoted.find("residual") != std::string::npos || quoted.find("cvode-") != std::string::npos) return true;
  auto a = std::sregex_iterator(quoted.begin(), quoted.end(), number);
  auto b = std::sregex_iterator(printed.begin(), printed.end(), number);
  for (; a != std::sregex_iterator(); ++a, ++b)
    if (!agree(a->str(), b->str(), numbers)) return false;
  return true;
}

/// A line `…` of the quotation stands for any number of printed lines.
inline bool same_text(const Lines& quoted, const Lines& printed, Numbers numbers, std::size_t i = 0,
                      std::size_t j = 0) {
  if (i == quoted.size()) return j == printed.size();
  if (quoted[i] == "…") {
    for (std::size_t k = j; k <= printed.size(); ++k)
      if (same_text(quoted, printed, numbers, i + 1, k)) return true;
    return false;
  }
  return j < printed.size() && same_line(quoted[i], printed[j], numbers) &&
         same_text(quoted, printed, numbers, i + 1, j + 1);
}

}  // namespace doc
