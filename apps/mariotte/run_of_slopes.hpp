// The run that slopes are of: it knows the limits of the model, slopes do not.
#pragma once
#include <string>
#include <vector>

#include "mariotte/study/capture.hpp"
#include "mariotte/study/sensitivity/capture_slopes.hpp"
#include "run_notes.hpp"

namespace mariotte::command {

/// What the outcomes are of: of a capture velocity a strike that is a little faster.
template <class Outcomes>
scene::Scene scene_of(const Outcomes& outcomes, const scene::Document& document, const scene::Scene& scene) {
  for (const auto& one : outcomes)
    if (one.name == study::capture_velocity_name) return study::at_speed(document, 1.0001 * *one.value);
  return scene;
}

/// The run of a scene gives its ending to slopes, unless these could not follow it; returns its warnings.
template <class Slopes>
std::vector<std::string> take_ending(Slopes& slopes, const scene::Scene& scene) {
  const auto run = scene::simulate(scene);
  const auto take = [&](const auto& one) {
    slopes.ending = one.ending;
    slopes.message = one.message;
  };
  if (exit_code(slopes.ending) != ExitCode::solver_failed) std::visit(take, run);
  return warnings(run, scene);
}

}  // namespace mariotte::command
