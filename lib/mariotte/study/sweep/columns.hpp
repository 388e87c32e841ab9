// The columns of a sweep: numbers of a result by their keys (impact/quantities/quantity_key.hpp).
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/core/error.hpp"
#include "mariotte/scene/document.hpp"
#include "mariotte/study/fault.hpp"

namespace mariotte::study {

/// A key that no result has; what() names it and the nearest known one.
struct ColumnError : Error {
  explicit ColumnError(const std::string& what) : Error(what, fault::unknown_column) {}
};

/// A key with an index that this scene has too few balls or contacts for.
struct BeyondEnd : ColumnError {
  using ColumnError::ColumnError;
};

/// One column, and what it is of.
struct Column {
  std::string key;                ///< "icr[0]"
  std::string unit = {};          ///< SI; "1" for a pure number, "SI" where it is not known
  std::string_view symbol = {};   ///< may be empty
  std::string_view meaning = {};  ///< one line
  std::string written = {};       ///< "name = expression" of one that is computed from others; else empty
};

/// Whether a scene may be run to tell how many elements `[*]` stands for; if not, and nothing less tells, it
/// stands for none.
enum class Counting { by_run, without_run };

/// The keys with `[*]` written out for a scene like this one, each once: "icr[*]" as "icr[0]", "icr[1]", …;
/// without any keys, those that say most about it. Nothing is simulated, unless * stands for something that
/// only a run can count, as events, and `counting` allows it. Throws ColumnError for a key that is no number
/// of such a result. Slopes are asked of the `document` that the scene was read from; without it there are
/// none.
std::vector<Column> expand_columns(const std::vector<std::string>& keys, const scene::Scene& scene,
                                   Counting counting = Counting::by_run,
                                   const scene::Document* document = nullptr);

}  // namespace mariotte::study
