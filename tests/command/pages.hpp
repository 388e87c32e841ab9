// What pages are made of in tests.
#pragma once
#include <string>

#include "session.hpp"

namespace support {

/// One of its four points is no scene.
inline std::string sweep_of_four() {
  std::string text = three_balls;
  text.erase(text.find("gap = 0\n"), 8);
  return text + R"(
[[sweep]]
key = "chain.precompressed"
values = [false, true]
[[sweep]]
key = "chain.gap"
values = [0, -0.125]
)";
}

}  // namespace support
