// The words of a result, which stand in its JSON beside the quantities.
#pragma once
#include <array>
#include <string_view>

namespace mariotte::report {

struct Label {
  std::string_view key;
  std::string_view meaning;
};

inline constexpr std::array labels = {
    Label{"ending",
          "how the run ended: `separated`, `captured`, `bound`, `time_limit` (by `until`, too, "
          "without a `message` then; the table says `time_limit (run.until)`), "
          "`event_limit`, `interrupted`, `unsure`, `invalid` or `failed`"},
    Label{"title", "title of the scene"},
    Label{"model", "`chain`, `network`, `microbody` or `bodies`"},
    Label{"message", "why the run ended so; left out if it ended by itself"},
    Label{"scene", "the model as it was understood, in SI units, of `mariotte run` and up to 1000 balls"},
    Label{"scene_text", "the scene file as it is, of `mariotte run` and up to 1000 balls"},
    Label{"skipped", "what this scene did not need, and why"},
    Label{"warnings[]",
          "suspicious values of the scene, an accuracy that was not reached, that nothing collides, "
          "contacts that faded, and where the model does not hold; left out if there are none"},
    Label{"provenance.version", "version of the program"},
    Label{"provenance.scene_sha256",
          "checksum of the scene file with its overrides and the tables that it names"},
    Label{"provenance.sundials", "version of SUNDIALS"},
    Label{"provenance.compiler", "compiler of the program"},
    Label{"provenance.build_type", "CMake's build type of the program"},
    Label{"provenance.scene", "scene file, of `mariotte run` and `sensitivity`"},
    Label{"provenance.overrides[]",
          "what `--set` and the like have changed, of `mariotte run` and `sensitivity`"},
};

}  // namespace mariotte::report
