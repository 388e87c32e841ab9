// Why a run stopped, as a sentence for the user.
#pragma once
#include <string>

#include "mariotte/hybrid/ending.hpp"
#include "mariotte/hybrid/options.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::report {

/// Whether a run went on until the time that the scene names as its end.
bool is_wanted(hybrid::Ending ending, const scene::Scene& scene);

/// "separated" and so on, as results say; "time_limit (run.until)" at the end that is wanted.
std::string ending_name(hybrid::Ending ending, const scene::Scene& scene);

/// The message of a run or, if it has none, the limit of `options` that was reached; empty if it came to an
/// end.
std::string reason(hybrid::Ending ending, const std::string& message, const hybrid::Options& options);
/// The same for a scene; empty at the end that it wants, too.
std::string reason(hybrid::Ending ending, const std::string& message, const scene::Scene& scene);

}  // namespace mariotte::report
