// Kinds of errors. What each means and how it is mended is told by `mariotte explain`, from doc/errors.md; a
// module declares those it finds.
#pragma once
#include <string_view>

namespace mariotte {

/// One kind, by its code in the catalogue.
struct Fault {
  std::string_view code;
};

namespace fault {
inline constexpr Fault no_quantity{"S020"}, unknown_unit{"S021"}, wrong_dimension{"S022"},
    out_of_range{"S023"};
inline constexpr Fault unknown_word{"S014"}, impossible{"S034"};
inline constexpr Fault stopped{"R002"};
}  // namespace fault

}  // namespace mariotte
