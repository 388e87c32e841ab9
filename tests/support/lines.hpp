// The lines of a text.
#pragma once
#include <sstream>
#include <string>
#include <vector>

namespace support {

inline std::vector<std::string> lines(const std::string& text) {
  std::vector<std::string> all;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

}  // namespace support
