// Counts in words.
#pragma once
#include <string>
#include <string_view>

namespace mariotte {

/// "1 point", "2 points"; `many` is the plural where it does not end in s.
template <class Count>
std::string counted(Count count, std::string_view one, std::string_view many = {}) {
  std::string text = std::to_string(count) + " ";
  if (count == 1) return text.append(one);
  return many.empty() ? text.append(one) + "s" : text.append(many);
}

}  // namespace mariotte
