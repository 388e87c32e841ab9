// Cells of a CSV: RFC 4180, on one line whatever they hold.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/scene/node.hpp"

namespace mariotte::report {

/// Text, quoted where it has to be.
std::string cell(std::string text);

/// A cell of a header with the unit of its column: "final.time [s]"; of a pure number, a word, or a number
/// whose unit is not told, the key alone.
std::string cell(const std::string& key, std::string_view unit);

/// The cells of a line, back from what `cell` made of them, into `cells`, whose memory is reused.
void split(std::string_view line, std::vector<std::string>& cells);

/// The number that a cell is; nan if it is none.
double number(std::string_view cell);

/// Appends a value of a scene: 17 significant digits, or text; nothing for what is neither.
void append_value(const scene::Node& node, std::string& text);

}  // namespace mariotte::report
