#include "mariotte/report/figure/label_places.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

namespace mariotte::report {
namespace {

/// Words that touch each other: their number, and the mean of where the first of them wants to be.
struct Block {
  std::size_t count;
  double first;
};

bool overlap(const Box& a, const Box& b) {
  return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

bool is_free(const Box& box, const std::vector<Box>& taken) {
  return std::none_of(taken.begin(), taken.end(), [&](const Box& other) { return overlap(box, other); });
}

}  // namespace

// Without the space below each word, its height may not fall from one to the next: an isotonic regression,
// by pooling neighbours that are in the wrong order.
std::vector<double> spread(const std::vector<double>& wanted, const std::vector<double>& space) {
  std::vector<std::size_t> order(wanted.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
  std::vector<double> below(order.size(), 0);  // from the middle of the lowest word to that of each
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i > 0) below[i] = below[i - 1] + 0.5 * (space[order[i - 1]] + space[order[i]]);
    blocks.push_back({1, wanted[order[i]] - below[i]});
    while (blocks.size() > 1 && blocks.back().first < blocks[blocks.size() - 2].first) {
      const auto upper = blocks.back();
      blocks.pop_back();
      auto& lower = blocks.back();
      const auto n = static_cast<double>(lower.count), m = static_cast<double>(upper.count);
      lower = {lower.count + upper.count, (n * lower.first + m * upper.first) / (n + m)};
    }
  }
  std::vector<double> places(order.size());
  std::size_t i = 0;
  const double highest = order.empty() ? 0 : 1 - below.back();
  for (const auto& block : blocks)
    for (std::size_t k = 0; k < block.count; ++k, ++i)
      places[order[i]] = std::max(0.0, std::min(block.first, highest)) + below[i];
  return places;
}

Box free_place(Box box, const std::vector<Box>& taken) {
  for (const double step : {0.25, -0.25})
    for (auto moved = box; moved.y + moved.height <= 1 && moved.y >= 0; moved.y += step * box.height)
      if (is_free(moved, taken)) return moved;
  return box;
}

Box free_place(const Box& box, const std::vector<Box>& taken, const std::vector<Box>& curves) {
  auto all = taken;
  all.insert(all.end(), curves.begin(), curves.end());
  std::optional<Box> best;
  const auto way = [&](const Box& one) {
    return std::hypot((one.x - box.x) / box.width, (one.y - box.y) / box.height);
  };
  for (const double shift : {0.0, 0.25, -0.25, 0.5, -0.5}) {
    auto moved = box;
    moved.x = std::clamp(box.x + shift * box.width, 0.0, std::max(0.0, 1 - box.width));
    moved = free_place(moved, all);
    if (is_free(moved, all) && (!best || way(moved) < way(*best))) best = moved;
  }
  return best ? *best : free_place(box, taken);
}

std::vector<int> rows_of_words(const std::vector<double>& at, const std::vector<double>& width, int rows) {
  std::vector<double> end(static_cast<std::size_t>(rows), -1e300);
  std::vector<int> row;
  for (std::size_t i = 0; i < at.size(); ++i) {
    const auto fits = [&](double last) { return last < at[i] - 0.5 * width[i]; };
    const auto found = std::find_if(end.begin(), end.end(), fits);
    row.push_back(found == end.end() ? -1 : static_cast<int>(found - end.begin()));
    if (found != end.end()) *found = at[i] + 0.5 * width[i];
  }
  return row;
}

}  // namespace mariotte::report
