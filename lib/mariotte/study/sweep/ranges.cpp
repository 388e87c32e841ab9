#include "mariotte/study/sweep/ranges.hpp"

#include <algorithm>

namespace mariotte::study {
namespace {

constexpr Index pieces_per_rank = 64;  ///< enough for slow and fast regions to even out
constexpr Index largest_piece = 4096;

}  // namespace

std::vector<PointRange> missing(std::vector<PointRange> done, Index points) {
  std::sort(done.begin(), done.end(),
            [](const PointRange& a, const PointRange& b) { return a.first < b.first; });
  std::vector<PointRange> rest;
  Index next = 0;
  for (const auto& one : done) {
    if (one.first > next) rest.push_back({next, one.first - next});
    next = std::max(next, one.first + one.count);
  }
  if (next < points) rest.push_back({next, points - next});
  return rest;
}

Index total(const std::vector<PointRange>& ranges) {
  Index sum = 0;
  for (const auto& one : ranges) sum += one.count;
  return sum;
}

Dealer::Dealer(std::vector<PointRange> points, Part part) {
  const Index piece =
      part.ranks == 1 ? total(points)
                      : std::clamp<Index>(total(points) / (part.ranks * pieces_per_rank), 1, largest_piece);
  Index number = 0;
  for (const auto& [first, count] : points)
    for (Index done = 0; done < count; done += piece)
      if (number++ % part.ranks == part.rank)
        pieces_.push_back({first + done, std::min(piece, count - done)});
  std::reverse(pieces_.begin(), pieces_.end());
}

PointRange Dealer::take(Index most) {
  if (pieces_.empty()) return {};
  auto& piece = pieces_.back();
  const PointRange taken{piece.first, std::min(most, piece.count)};
  piece = {piece.first + taken.count, piece.count - taken.count};
  if (piece.count == 0) pieces_.pop_back();
  return taken;
}

}  // namespace mariotte::study
