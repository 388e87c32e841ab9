// The same for one instruction set: included by one source file for each, which names the namespace.
#pragma once
#include "mariotte/flow/taylor/taylor_registers.hpp"
#include "mariotte/impact/sensitivity/adjoint/contact_turn.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {
namespace {

namespace registers = flow::taylor::MARIOTTE_INSTRUCTION_SET;

/// A number at all points.
constexpr int parts = stages / registers::width;
using Points = registers::LaneVector<parts>;

MARIOTTE_SERIES_INLINE Points read(const double* from) {
  return registers::load_loose<parts>(from);
}

/// ∫ of a rate from each point to the end.
MARIOTTE_SERIES_INLINE Points until_end(const UntilEnd& by, const double* rate) {
  Points even = rate[0] * read(by.weight[0]), odd = rate[1] * read(by.weight[1]);
#pragma GCC unroll 8
  for (int j = 2; j < stages; j += 2) {
    even = even + rate[j] * read(by.weight[j]);
    odd = odd + rate[j + 1] * read(by.weight[j + 1]);
  }
  return even + odd;
}

void turn(const ContactTurn& c) {
  const Points mu = c.right_mobility * read(c.right) - c.left_mobility * read(c.left);
  registers::store_loose(mu, c.mu);
  registers::store_loose(read(c.by_depth) * mu, c.gap_rate);
  const auto left = Points(c.held) - until_end(c.until_end, c.gap_rate);
  registers::store_loose(read(c.pace) * left - read(c.by_rate) * mu, c.velocity_rate);
  const auto turned = until_end(c.until_end, c.velocity_rate);
  registers::store_loose(read(c.next_left) - turned, c.next_left);
  registers::store_loose(read(c.next_right) + turned, c.next_right);
}

}  // namespace
}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET

mariotte::impact::TurnContact mariotte::impact::MARIOTTE_INSTRUCTION_SET::choose_turn() {
  return turn;
}
