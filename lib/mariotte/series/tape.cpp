#include "mariotte/series/tape.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

namespace mariotte::series {
namespace {

std::size_t hash(const TapeNode& node) {
  auto h = std::bit_cast<std::uint64_t>(node.number) * 0x9e3779b97f4a7c15u;
  h ^= (static_cast<std::uint64_t>(node.a + 1) << 32) ^ static_cast<std::uint64_t>(node.b + 1);
  h = (h ^ (h >> 29)) * 0xbf58476d1ce4e5b9u + static_cast<std::uint64_t>(node.op);
  return static_cast<std::size_t>(h ^ (h >> 32));
}

constexpr std::size_t first_slots = 1024;

/// Operations that come by twos: of the first one, the second.
std::optional<TapeOp> companion(TapeOp op) {
  if (op == TapeOp::sine) return TapeOp::cosine;
  if (op == TapeOp::width) return TapeOp::square_of_width;
  return std::nullopt;
}
bool is_companion(TapeOp op) {
  return op == TapeOp::cosine || op == TapeOp::square_of_width;
}

}  // namespace

void Tape::clear() {
  nodes_.clear();
  std::fill(slots_.begin(), slots_.end(), -1);
}

int Tape::append(const TapeNode& node) {
  nodes_.push_back(node);
  return static_cast<int>(nodes_.size()) - 1;
}

int Tape::put(const TapeNode& node) {
  if (2 * nodes_.size() >= slots_.size()) grow();
  const std::size_t mask = slots_.size() - 1;
  std::size_t slot = hash(node) & mask;
  for (; slots_[slot] >= 0; slot = (slot + 1) & mask)
    if (nodes_[slots_[slot]] == node) return slots_[slot];
  const int place = slots_[slot] = append(node);
  if (const auto second = companion(node.op)) append({.op = *second, .a = node.a});
  return place;
}

void Tape::grow() {
  slots_.assign(std::max(first_slots, 2 * slots_.size()), -1);
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (is_companion(nodes_[i].op)) continue;
    std::size_t slot = hash(nodes_[i]) & mask;
    while (slots_[slot] >= 0) slot = (slot + 1) & mask;
    slots_[slot] = static_cast<int>(i);
  }
}

}  // namespace mariotte::series
