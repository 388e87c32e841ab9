#include "mariotte/flow/kind.hpp"

#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::flow {

std::string_view name(std::optional<Kind> kind) {
  constexpr std::array<std::string_view, kinds.size()> names = {
      "ballistic",       "pair",           "modal",        "taylor", "cvode-adams",
      "cvode-bdf-dense", "cvode-bdf-band", "cvode-bdf-klu"};
  return kind ? names[static_cast<std::size_t>(*kind)] : "auto";
}

std::optional<Kind> parse_kind(std::string_view text) {
  if (text == name(std::nullopt)) return std::nullopt;
  std::string known(name(std::nullopt));
  for (const auto kind : kinds) {
    if (kind == Kind::ballistic) continue;
    if (name(kind) == text) return kind;
    known += ", " + std::string(name(kind));
  }
  throw InvalidParameter("unknown flow '" + std::string(text) + "' (one of: " + known + ")",
                         fault::unknown_word);
}

}  // namespace mariotte::flow
