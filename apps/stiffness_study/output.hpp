// Rows and statements as text.
#pragma once
#include <string>

#include "study.hpp"

namespace mariotte::stiffness_study {

/// A table per series, family and flow, and what cut it short.
std::string table(const Rows& rows);

/// One line per run, 17 significant digits; lists are separated by spaces, unknown numbers are empty.
std::string csv(const Rows& rows);

/// "theorem holds: …", "theorem FAILS: …" and "measured: …".
std::string text(const std::vector<Statement>& statements);

}  // namespace mariotte::stiffness_study
