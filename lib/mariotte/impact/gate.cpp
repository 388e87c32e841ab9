#include "mariotte/impact/gate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace mariotte::impact {
namespace {

/// How many times larger than allowed.
double excess(const Balance& balance) {
  const double size = std::abs(balance.size);
  if (size <= balance.allowed) return 0;
  return std::isfinite(size) && balance.allowed > 0 ? size / balance.allowed : HUGE_VAL;
}

std::string described(const Balance& balance) {
  char text[256];
  std::snprintf(text, sizeof text,
                "the result is not to be trusted: %s is off by %.3g, where the accuracy explains %.3g; "
                "try another accuracy, or --flow cvode-adams",
                balance.name, std::abs(balance.size), balance.allowed);
  return text;
}

}  // namespace

bool closes(std::span<const Balance> balances) {
  return std::all_of(balances.begin(), balances.end(),
                     [](const Balance& balance) { return excess(balance) == 0; });
}

void pass_gate(std::span<const Balance> balances, hybrid::Ending& ending, std::string& message) {
  if (ending == hybrid::Ending::failed || ending == hybrid::Ending::unsure) return;
  const Balance* worst = nullptr;
  for (const auto& balance : balances)
    if (excess(balance) > (worst ? excess(*worst) : 0)) worst = &balance;
  if (!worst) return;
  ending = hybrid::Ending::unsure;
  message = described(*worst);
}

}  // namespace mariotte::impact
