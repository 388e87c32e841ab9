// Where a file of numbers comes from, as names and words.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

using Attributes = std::vector<std::pair<std::string, std::string>>;

/// The provenance of a result; lists are joined by "; ".
Attributes attributes(const Json& provenance);

}  // namespace mariotte::report
