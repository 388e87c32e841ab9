// Where the model of a run does not hold, as sentences.
#pragma once
#include <string>
#include <vector>

#include "mariotte/impact/validity.hpp"

namespace mariotte::report {

/// One per number beyond its limit: "contact 3: max a/R = 0.31 is above 0.1: strains are …"; `thing` is
/// "contact" or "tip".
std::vector<std::string> warnings(const impact::Validity& validity, const char* thing);

}  // namespace mariotte::report
