// A chain whose results have many rows, and how many.
#pragma once
#include <algorithm>
#include <string>

namespace support {

inline constexpr const char* sixty_balls = R"(title = "Sixty balls"
[chain]
mass = 1
law = "hertz"
stiffness = 1
balls = 60
[[chain.ball]]
number = 1
velocity = 1
)";

inline std::size_t lines(const std::string& text) {
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

}  // namespace support
