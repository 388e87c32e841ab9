// Programs that come with mariotte and run in its place.
#pragma once
#include <string>
#include <vector>

namespace mariotte::command {

/// Becomes the program of this name, installed beside this one or built in the folder next to it; returns
/// never. Throws Error if there is none or it does not start.
[[noreturn]] void become(const std::string& name, const std::vector<std::string>& arguments);

}  // namespace mariotte::command
