// The page that describes results, doc/result_format.md.
#pragma once
#include <string>

namespace mariotte::report {

/// All keys of the results of every model with symbol, unit, meaning and cost, in Markdown.
std::string result_format();

}  // namespace mariotte::report
