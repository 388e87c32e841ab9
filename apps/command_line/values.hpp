// Values of options: how they are read, and checks of them that say what is wrong, or nothing.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/core/dimension.hpp"

namespace mariotte::command {

/// The number that the whole text is, "inf" and "nan" included; nothing if it is none.
std::optional<double> number(const std::string& text);

/// What stands between the separators; the empty text has one part, and none follows a last separator.
std::vector<std::string> split(const std::string& text, char separator);

/// The value in SI of an option that takes a number with a unit. Throws UsageError that names the option.
double quantity(const std::string& option, const std::string& text, const Dimension& dimension);
/// The same of one that must be positive, and finite.
double positive_quantity(const std::string& option, const std::string& text, const Dimension& dimension);

std::string is_accuracy(const std::string& text);
std::string is_flow(const std::string& text);
/// "-" is standard output to many programs, but not to these.
std::string is_file_name(const std::string& text);

}  // namespace mariotte::command
