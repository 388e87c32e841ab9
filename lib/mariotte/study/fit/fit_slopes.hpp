// Which of what is measured has exact slopes, and how these follow from those of a run.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mariotte/impact/sensitivity/sensitivity.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::study {

/// By free key; empty where there is none, or it is not known.
using Slopes = std::vector<std::optional<double>>;

/// What `impact::sensitivity` calls these numbers of a result; empty if it has no slopes of one of them.
std::vector<std::string> outcomes_of(const std::vector<std::string>& keys, const scene::Scene& scene);

/// Restitution is that of the first impact, and ends there.
model::Microbody first_impact(model::Microbody body);

/// Slopes of an outcome; zero of what is captured, or depends on a key by rounding only, and none of a run
/// that has failed.
Slopes slopes_of(const impact::Sensitivity& found, const std::string& outcome);

}  // namespace mariotte::study
