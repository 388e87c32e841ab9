#include "mariotte/core/nearest.hpp"

#include <algorithm>
#include <utility>

namespace mariotte {
namespace {

constexpr int edit = 2;              // whole edits count double, so that a changed case can count one
constexpr std::size_t longest = 64;  // beyond this nothing is a misspelling, and the table stays small

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

int replacing(char a, char b) {
  if (a == b) return 0;
  return lower(a) == lower(b) ? 1 : edit;
}

/// Optimal string alignment distance in half edits.
int distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<int> table((a.size() + 1) * width);
  const auto at = [&](std::size_t i, std::size_t j) -> int& { return table[i * width + j]; };
  for (std::size_t i = 0; i <= a.size(); ++i) at(i, 0) = static_cast<int>(i) * edit;
  for (std::size_t j = 0; j <= b.size(); ++j) at(0, j) = static_cast<int>(j) * edit;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      at(i, j) = std::min(
          {at(i - 1, j) + edit, at(i, j - 1) + edit, at(i - 1, j - 1) + replacing(a[i - 1], b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        at(i, j) = std::min(at(i, j), at(i - 2, j - 2) + edit);
    }
  return at(a.size(), b.size());
}

std::string meant(std::string_view name) {
  return " (did you mean '" + std::string(name) + "'?)";
}

}  // namespace

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
  if (word.size() > longest) return {};
  std::string_view best;
  // A third of the word may be wrong, and always one letter.
  int least = std::max(edit, edit * static_cast<int>((word.size() + 2) / 3)) + 1;
  for (const auto candidate : candidates) {
    // Nothing of a word survives if every letter is replaced.
    const int cost = distance(word, candidate);
    if (cost < least && cost < edit * static_cast<int>(std::max(word.size(), candidate.size()))) {
      least = cost;
      best = candidate;
    }
  }
  return best;
}

std::vector<std::string_view> nearest_few(std::string_view word, std::span<const std::string_view> candidates,
                                          std::size_t count) {
  std::vector<std::pair<int, std::string_view>> ranked;
  for (const auto candidate : candidates) {
    const bool holds = candidate.find(word) != candidate.npos || word.find(candidate) != word.npos;
    ranked.emplace_back(holds ? 0 : distance(word.substr(0, longest), candidate), candidate);
  }
  std::stable_sort(ranked.begin(), ranked.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string_view> names;
  for (const auto& one : ranked)
    if (names.size() < count) names.push_back(one.second);
  return names;
}

std::string suggestion(std::string_view word, std::span<const std::string_view> candidates) {
  const auto found = nearest(word, candidates);
  return found.empty() || found == word ? std::string() : meant(found);
}

std::string suggestion_or_few(std::string_view word, std::span<const std::string_view> candidates) {
  const auto one = suggestion(word, candidates);
  if (!one.empty() || candidates.empty()) return one;
  std::string few;
  for (const auto name : nearest_few(word, candidates, 3)) (few += few.empty() ? "" : ", ") += name;
  return " (nearest: " + few + ")";
}

std::string suggested_path(std::string_view word, std::span<const std::string_view> candidates) {
  const auto end = "." + std::string(word);
  for (const auto one : candidates)
    if (one.ends_with(end)) return meant(one);
  return suggestion(word, candidates);
}

}  // namespace mariotte
