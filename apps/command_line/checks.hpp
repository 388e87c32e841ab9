// Checks of option values: empty if fine, else what is wrong, as CLI11 wants it.
#pragma once
#include <string>

namespace mariotte::command {

std::string is_accuracy(const std::string& text);
std::string is_flow(const std::string& text);

}  // namespace mariotte::command
