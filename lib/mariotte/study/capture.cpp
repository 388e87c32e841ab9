#include "mariotte/study/capture.hpp"

#include <cmath>

#include "mariotte/scene/field.hpp"
#include "mariotte/scene/key_path.hpp"
#include "mariotte/scene/restitution.hpp"
#include "mariotte/study/pair_choice.hpp"

namespace mariotte::study {
namespace {

/// A restitution is kept at every speed unless the scene says at which one it was measured.
bool always_parts(const scene::Document& document) {
  const auto surface = scene::find(scene::Field{&document.tree, ""}, "surface");
  return surface && scene::find(*surface, "restitution") && !scene::find(*surface, "at");
}

void expect_captured(const scene::Scene& scene, const std::string& file) {
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  if (!std::holds_alternative<model::Microbody>(scene.model) && !(chain && chain->law.size() == 1))
    throw scene::SceneError(file + ": only a [body], or two bodies of a [chain], can be captured",
                            fault::no_model);
}

}  // namespace

model::Chain struck(model::Chain pair, double speed) {
  if (std::isfinite(pair.mass[0]))
    pair.velocity = {speed, 0};
  else
    pair.velocity = {0, -speed};
  pair.gap = {0};
  pair.gravity = 0;
  return pair;
}

std::optional<impact::CaptureVelocity> capture_velocity(scene::Document document, double tolerance,
                                                        const std::function<void()>& watch) {
  if (!(tolerance >= finest_capture && tolerance <= widest_capture))
    throw InvalidParameter("the tolerance of a capture velocity lies between 1e-15 and 0.5");
  const auto scene = resolve(document);
  expect_captured(scene, document.source.name);
  if (const auto* chain = std::get_if<model::Chain>(&scene.model)) {
    const double approach = scene::largest_approach(*chain);
    return impact::capture_velocity(pair_of(scene, document.source.name, "captured"),
                                    approach > 0 ? approach : 1, tolerance);
  }
  const auto& body = std::get<model::Microbody>(scene.model);
  if (always_parts(document)) return std::nullopt;
  // ζ's are read again at every speed, since the damping they stand for depends on it.
  const auto at_speed = [&](double speed) {
    watch();
    locate(document.source, document.tree, speed_key, {}).value = speed;
    return std::get<model::Microbody>(resolve(document).model);
  };
  return impact::capture_velocity(at_speed, -body.velocity.e1, tolerance, scene.run);
}

scene::Scene at_speed(scene::Document document, double speed) {
  auto scene = resolve(document);
  if (auto* chain = std::get_if<model::Chain>(&scene.model)) {
    *chain = struck(*chain, speed);
    scene.run = {.accuracy = scene.run.accuracy};
    scene.until = false;
    return scene;
  }
  locate(document.source, document.tree, speed_key, {}).value = speed;
  return resolve(document);
}

}  // namespace mariotte::study
