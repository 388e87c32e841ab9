// CRC-32 as zip, PNG and Ethernet have it, to tell a whole line from a torn one [ISO 3309].
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace mariotte::study {

namespace detail {

/// Remainders of all bytes, for the bit-reversed polynomial.
constexpr std::array<std::uint32_t, 256> crc32_table() {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t byte = 0; byte < table.size(); ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? 0xedb88320u : 0u);
    table[byte] = rest;
  }
  return table;
}

}  // namespace detail

constexpr std::uint32_t crc32(std::string_view bytes) {
  constexpr auto table = detail::crc32_table();
  std::uint32_t rest = 0xffffffff;
  for (const char byte : bytes) rest = rest >> 8 ^ table[(rest ^ static_cast<unsigned char>(byte)) & 0xff];
  return ~rest;
}

}  // namespace mariotte::study
