// CRC-32 as zip, PNG and Ethernet have it, to tell a whole line from a torn one [ISO 3309].
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace mariotte::study {

namespace detail {

inline constexpr int stride = 8;  ///< bytes that are looked up at once

/// Remainders of all bytes, for the bit-reversed polynomial, with 0, 1, … zeros after them.
constexpr auto crc32_tables() {
  std::array<std::array<std::uint32_t, 256>, stride> table{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t rest = byte;
    for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? 0xedb88320u : 0u);
    table[0][byte] = rest;
  }
  for (int zeros = 1; zeros < stride; ++zeros)
    for (std::uint32_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t before = table[zeros - 1][byte];
      table[zeros][byte] = before >> 8 ^ table[0][before & 0xff];
    }
  return table;
}

}  // namespace detail

constexpr std::uint32_t crc32(std::string_view bytes) {
  constexpr auto table = detail::crc32_tables();
  const auto at = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i]));
  };
  std::uint32_t rest = 0xffffffff;
  std::size_t i = 0;
  for (; i + detail::stride <= bytes.size(); i += detail::stride) {
    rest ^= at(i) | at(i + 1) << 8 | at(i + 2) << 16 | at(i + 3) << 24;
    std::uint32_t next = 0;
    for (std::size_t k = 0; k < 4; ++k)
      next ^= table[7 - k][rest >> 8 * k & 0xff] ^ table[3 - k][at(i + 4 + k)];
    rest = next;
  }
  for (; i < bytes.size(); ++i) rest = rest >> 8 ^ table[0][(rest ^ at(i)) & 0xff];
  return ~rest;
}

}  // namespace mariotte::study
