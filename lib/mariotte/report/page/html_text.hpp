// Small pieces of HTML.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// Text that stands for itself, in elements and in attributes.
std::string escaped(std::string_view text);

std::string base64(std::string_view bytes);

/// Of a longer list the beginning is told on a line.
inline constexpr std::size_t most_inline = 12;

/// A number, word or list on one line: eight digits, a dash for null, the beginning of a long list.
std::string inline_text(const Json& value);

}  // namespace mariotte::report
