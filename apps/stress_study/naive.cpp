#include "run.hpp"
#include "support/naive_bodies.hpp"
#include "support/naive_body.hpp"
#include "support/naive_chain.hpp"

namespace mariotte::stress_study {
namespace {

Found found_in(const model::Chain& chain, const test::NaiveRun& run, double end) {
  Found found{.ending = hybrid::Ending::time_limit, .time = end, .value = run.velocity};
  for (std::size_t i = 0; i < found.value.size(); ++i)
    if (std::isfinite(chain.mass[i])) found.value[i] += chain.gravity * end;
  return found;
}

Found found_in(const model::Network& network, const test::NaiveRun& run, double end) {
  Found found{.ending = hybrid::Ending::time_limit, .time = end};
  for (const auto& direction : network.direction) found.value.push_back(gap_rate(direction, run.velocity));
  return found;
}

template <class Contacts>
std::optional<Found> follow(const Contacts& model, const test::NaiveSettings& settings) {
  const auto run = test::run_naive(test::naive_contacts(model), settings);
  if (!run.complete) return {};
  auto found = found_in(model, run, settings.end);
  for (double& value : found.value) value /= settings.speed;
  return found;
}

std::optional<Found> follow(const Body& scene, const test::NaiveSettings& settings) {
  const auto& body = scene.body;
  const test::NaiveBody field(body, settings.speed, settings.effort);
  auto y = field.start();
  Index steps = 0;
  if (!test::follow_naively(field, y, settings.end, settings.effort, steps)) return {};
  const Vector3 v = field.velocity(y),
                w = (norm(body.body.tips[0].centre) + body.body.tips[0].radius) * field.spin(y);
  Found found{.ending = hybrid::Ending::time_limit, .time = settings.end};
  found.value = {v.e1 + body.gravity * settings.end, v.e2, v.e3, w.e1, w.e2, w.e3};
  for (double& value : found.value) value /= settings.speed;
  return found;
}

/// A step costs little: so many for one of the others.
constexpr Index steps_for_one = 20;

std::optional<Found> follow(const Group& scene, const test::NaiveSettings& settings) {
  if (!test::NaiveBodies::can_follow(scene.bodies)) return {};
  test::NaiveBodies run(scene.bodies, settings.speed, settings.effort);
  if (!run.follow(settings.end, steps_for_one * settings.effort.most_steps)) return {};
  Found found{.ending = hybrid::Ending::time_limit, .time = settings.end};
  for (std::size_t i = 0; i < run.bodies().size(); ++i)
    add_motion(scene, i, run.bodies()[i].velocity, run.bodies()[i].spin, found);
  for (double& value : found.value) value /= settings.speed;
  return found;
}

}  // namespace

std::optional<Found> run_naively(const Scene& scene, double end, const test::Effort& effort) {
  const test::NaiveSettings settings{.end = end, .speed = reference_speed(scene.model), .effort = effort};
  return std::visit([&](const auto& model) { return follow(model, settings); }, scene.model);
}

}  // namespace mariotte::stress_study
