#include "friction_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "friction_rivals.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"

namespace mariotte::work_precision {
namespace {

using model::Bodies;
using model::TangentialLaw;

constexpr double radius = 0.01, mass = 0.033, stiffness = 1e10;

struct Case {
  const char* name;
  Bodies bodies;
};

model::Body ball(const Vector3& position, const Vector3& velocity, double spin) {
  const double moment = 0.4 * mass * radius * radius;
  return {.mass = mass,
          .inertia = {moment, moment, moment},
          .spheres = {{{}, radius}},
          .position = position,
          .velocity = velocity,
          .spin = {0, 0, spin}};
}

model::BodyContact contact(const model::Feature& a, Index b, const model::Tangential& tangential) {
  return {.a = a, .b = {b, 0}, .law = contact::Hertz(stiffness), .tangential = tangential};
}

Bodies oblique_sphere(const model::Tangential& tangential) {
  Bodies bodies{.dimension = 2};
  bodies.body = {ball({0, 1.1 * radius, 0}, {0.7, -1, 0}, 20)};
  bodies.plane = {{.normal = {0, 1, 0}}};
  bodies.contact = {contact({0, -1}, 0, tangential)};
  return bodies;
}

/// One ball strikes a triangle of others with spin, all pairs with friction.
Bodies balls(int rows, double spacing, const model::Tangential& tangential) {
  Bodies bodies{.dimension = 2};
  const double apart = spacing * radius;
  for (int row = 0; row < rows; ++row)
    for (int place = 0; place <= row; ++place)
      bodies.body.push_back(ball({0.5 * std::sqrt(3) * apart * row, apart * (place - 0.5 * row), 0}, {}, 0));
  bodies.body.push_back(ball({-2.5 * radius, 0.1 * radius, 0}, {2, 0.2, 0}, -60));
  for (Index b = 1; b < std::ssize(bodies.body); ++b)
    for (Index a = 0; a < b; ++a) {
      bodies.contact.push_back(contact({a, 0}, b, tangential));
      const double gap = norm(bodies.body[a].position - bodies.body[b].position) - 2 * radius;
      bodies.contact.back().touching = std::abs(gap) < 1e-9 * radius;
    }
  return bodies;
}

std::vector<Case> cases() {
  const model::Tangential mindlin{TangentialLaw::mindlin, 0.2, 0.8 * stiffness};
  return {{"oblique sphere, Mindlin", oblique_sphere(mindlin)},
          {"oblique sphere, rigid", oblique_sphere({TangentialLaw::rigid, 0.2, 0})},
          {"two balls, Mindlin", balls(1, 2.06, mindlin)},
          {"rack of 6, Mindlin", balls(3, 2.06, mindlin)},
          {"touching 6, Mindlin", balls(3, 2, mindlin)}};
}

/// Two velocities and spin × radius of each ball.
std::vector<double> velocities(const impact::BodiesImpact& impact) {
  std::vector<double> list;
  for (const auto& body : impact.body)
    list.insert(list.end(), {body.velocity.e1, body.velocity.e2, radius * body.spin.e3});
  return list;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

struct Cost {
  double seconds, error;
};

Cost cost(const Bodies& bodies, const hybrid::Options& options, const std::vector<double>& truth,
          const measuring::Patience& patience) {
  const auto run = [&] { impact::simulate(bodies, options); };
  return {measuring::least_seconds(run, measuring::timed(run), patience),
          difference(velocities(impact::simulate(bodies, options)), truth)};
}

std::string microseconds(std::optional<double> seconds) {
  return seconds ? fmt::format("{:.1f}", 1e6 * *seconds) : "–";
}

std::string line(const Case& c, double accuracy, const std::vector<double>& truth,
                 const FrictionRivals& rivals, const measuring::Patience& patience) {
  const auto series = cost(c.bodies, {.accuracy = accuracy}, truth, patience);
  const auto adams = cost(c.bodies, {.accuracy = accuracy, .flow = flow::Kind::cvode_adams}, truth, patience);
  return fmt::format("{:<24}  {:>8.0e}  {:>9.1f}  {:>8.1e}  {:>9.1f}  {:>8.1e}  {:>5.1f}  {:>9}  {:>9}\n",
                     c.name, accuracy, 1e6 * series.seconds, series.error, 1e6 * adams.seconds, adams.error,
                     adams.seconds / series.seconds, microseconds(least_time(rivals.odeint, accuracy)),
                     microseconds(least_time(rivals.verlet, accuracy)));
}

}  // namespace

std::string friction_cost(const measuring::Patience& patience) {
  std::string text =
      fmt::format("{:<24}  {:>8}  {:>9}  {:>8}  {:>9}  {:>8}  {:>5}  {:>9}  {:>9}\n", "bodies with friction",
                  "accuracy", "auto/µs", "error", "Adams/µs", "error", "ratio", "odeint/µs", "Verlet/µs");
  for (const auto& c : cases()) {
    const auto end = impact::simulate(c.bodies, {.accuracy = 1e-11, .flow = flow::Kind::cvode_adams});
    const auto truth = velocities(end);
    const auto error = [&](const std::vector<double>& found) { return difference(found, truth); };
    const auto rivals = friction_rivals(c.bodies, 1.001 * end.time, error, patience);
    for (const double accuracy : {1e-6, 1e-8, 1e-10}) text += line(c, accuracy, truth, rivals, patience);
  }
  return text;
}

}  // namespace mariotte::work_precision
