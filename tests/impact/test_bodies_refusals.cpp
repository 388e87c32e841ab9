// Bodies with friction that are refused, by name.
#include <boost/test/unit_test.hpp>
#include <string>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"

using namespace mariotte;
using model::TangentialLaw;

namespace {

/// Two balls in the plane with radii of 10 mm, the second at `position`.
model::Bodies pair(const model::Tangential& tangential, const Vector3& position = {0.0195, 0.006, 0}) {
  constexpr double mass = 0.033, radius = 0.01, moment = 0.4 * mass * radius * radius;
  model::Bodies bodies{.dimension = 2};
  for (const auto& [place, velocity] : {std::pair{Vector3{}, Vector3{1, 0.3, 0}}, {position, {-0.2, 0.1, 0}}})
    bodies.body.push_back({.name = "",
                           .mass = mass,
                           .inertia = {moment, moment, moment},
                           .spheres = {{{}, radius}},
                           .position = place,
                           .velocity = velocity});
  bodies.contact = {{.a = {0, 0}, .b = {1, 0}, .law = contact::Hertz(1e6), .tangential = tangential}};
  bodies.named = 1;
  return bodies;
}

auto says(const std::string& text) {
  return [text](const Error& error) { return std::string(error.what()).find(text) != std::string::npos; };
}

}  // namespace

// Flat on two corners, only the sum of both frictions is determined.
BOOST_AUTO_TEST_CASE(redundant_rigid_stick_is_refused_by_name) {
  model::Bodies bodies{.dimension = 2};
  bodies.body = {{.name = "block",
                  .mass = 1,
                  .inertia = {0, 0, 0.01},
                  .spheres = {{{-0.1, -0.1, 0}, 0}, {{0.1, -0.1, 0}, 0}},
                  .position = {0, 0.1, 0},
                  .velocity = {0, -0.5, 0}}};
  bodies.plane = {{.name = "", .point = {}, .normal = {0, 1, 0}, .velocity = {}}};
  for (Index corner = 0; corner < 2; ++corner)
    bodies.contact.push_back({.a = {0, -1},
                              .b = {0, corner},
                              .law = contact::Linear(1e6),
                              .tangential = {TangentialLaw::rigid, 0.5, 0},
                              .touching = true});
  BOOST_CHECK_EXCEPTION(impact::simulate(bodies), Error, [](const Error& error) {
    return error.fault.code == "S036" && std::string(error.what()).find("indeterminate") != std::string::npos;
  });
}

BOOST_AUTO_TEST_CASE(overlaps_are_refused_by_name) {
  const auto bodies = pair({TangentialLaw::mindlin, 0.2, 1.2e6}, {0.01, 0, 0});
  BOOST_CHECK_EXCEPTION(impact::simulate(bodies), InvalidParameter, says("body 1 and body 2 overlap"));
}

BOOST_AUTO_TEST_CASE(what_is_stated_to_touch_stands_there_about) {
  const auto touching = [](double apart) {
    auto bodies = pair({TangentialLaw::rigid, 0.1, 0}, {apart * 0.02, 0, 0});
    bodies.contact[0].touching = true;
    return bodies;
  };
  for (const double apart : {0.0, 0.8, 1.2, 50.0})
    BOOST_CHECK_EXCEPTION(impact::simulate(touching(apart)), InvalidParameter, says("touching = true, but"));
  for (const double apart : {0.95, 1.05}) BOOST_CHECK_NO_THROW(impact::simulate(touching(apart)));
}

BOOST_AUTO_TEST_CASE(friction_that_rounding_would_lose_is_refused_by_name) {
  for (const double friction : {-0.1, 2e9, 1e300})
    BOOST_CHECK_EXCEPTION(impact::simulate(pair({TangentialLaw::rigid, friction, 0})), InvalidParameter,
                          says("friction must be"));
  BOOST_TEST((impact::simulate(pair({TangentialLaw::rigid, 1e9, 0})).ending == hybrid::Ending::separated));
}
