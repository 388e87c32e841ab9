// stdout carries the result and nothing else; every other word goes to stderr.
#pragma once
#include <string>
#include <string_view>

#include "mariotte/core/fault.hpp"

namespace mariotte::command {

/// The name before every message on stderr.
void speak_as(std::string program);

/// Nobody reads what is written to stdout any more, as after `| head -1`; no fault that is worth a word.
struct ReaderGone {};

/// Write to stdout. Throws ReaderGone, or report::FileError unless every byte was taken.
void print(std::string_view text);

/// "<program>: error: … [S012]", "<program>: warning: …" and "<program>: …" on stderr.
void error(std::string_view message, Fault fault) noexcept;
void warning(std::string_view message) noexcept;
void note(std::string_view message) noexcept;

}  // namespace mariotte::command
