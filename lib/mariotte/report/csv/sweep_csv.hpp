// A sweep as CSV: one row per point, in their order.
#pragma once
#include <string>
#include <vector>

#include "mariotte/study/sweep/batch.hpp"

namespace mariotte::report {

/// The varied keys and the columns, each with its unit in brackets, then `ending,reason`.
std::string sweep_header(const study::Design& design, const std::vector<study::Column>& columns);

/// A cell of the header without its unit.
std::string key_of_column(const std::string& name);
/// Its unit; "1" without one.
std::string unit_of_column(const std::string& name);

/// Appends the first cells of a point's row, what it gives to the varied keys, each with a comma after it.
void append_parameters(const study::Design& design, Index point, std::string& text);

/// Appends the rows of a batch: 17 significant digits in SI, empty where there is no number.
void append_rows(const study::Design& design, const study::Batch& batch, std::string& text);

}  // namespace mariotte::report
