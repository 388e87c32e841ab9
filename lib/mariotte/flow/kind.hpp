// The kinds of flows, and their names.
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace mariotte::flow {

/// The flows there are.
enum class Kind {
  ballistic,
  pair,
  modal,
  taylor,
  cvode_adams,
  cvode_bdf_dense,
  cvode_bdf_band,
  cvode_bdf_klu
};
inline constexpr std::array kinds = {Kind::ballistic,      Kind::pair,         Kind::modal,
                                     Kind::taylor,         Kind::cvode_adams,  Kind::cvode_bdf_dense,
                                     Kind::cvode_bdf_band, Kind::cvode_bdf_klu};

/// True of those that integrate by CVODE.
inline bool is_cvode(Kind kind) {
  return kind >= Kind::cvode_adams;
}

/// "ballistic", "pair", "modal", "taylor", "cvode-adams", "cvode-bdf-dense", "cvode-bdf-band",
/// "cvode-bdf-klu"; "auto" where no kind is asked for.
std::string_view name(std::optional<Kind> kind);

/// The flow of this name, for contact phases; empty for "auto". Throws InvalidParameter for any other name,
/// and for "ballistic", which follows no contact.
std::optional<Kind> parse_kind(std::string_view name);

}  // namespace mariotte::flow
