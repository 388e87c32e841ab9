// Verdicts on their way from one process to another.
#pragma once
#include <string>

#include "examine.hpp"

namespace mariotte::stress_study {

std::string packed(const Verdict& verdict);
Verdict unpacked(const std::string& text);

}  // namespace mariotte::stress_study
