// Rigid slips in space that begin from rest again.
#define BOOST_TEST_MODULE impact_slips_from_rest
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/impact/bodies/bodies_impact.hpp"

using namespace mariotte;

namespace {

model::Body ball(double mass, const Vector3& position, const Vector3& velocity, const Vector3& spin) {
  constexpr double radius = 0.01;
  const double moment = 0.4 * mass * radius * radius;
  return {.mass = mass,
          .inertia = {moment, moment, moment},
          .spheres = {{{}, radius}},
          .position = position,
          .velocity = velocity,
          .spin = spin};
}

/// Three balls that strike each other and spin. A contact that has stuck slips shortly before it opens.
model::Bodies ring() {
  model::Bodies bodies;
  bodies.body = {ball(0.023755937962695334, {0.01156800155932439, 0, 0},
                      {-0.92316448057034484, 0.10486999952883194, 0.17213638501749193}, {}),
                 ball(0.059146782838878767, {-0.0057828870621291556, 0.010016254206040421, 0},
                      {0.61737558276804405, -0.81240400135994739, 0.06242006532766578},
                      {5.0254093463028831, 11.760419775336228, -4.7951855977732611}),
                 ball(0.053221991713318977, {-0.0057742655109450499, -0.010001321241349477, 0},
                      {0.38752417431950337, 0.67573697655198584, 0.080323022185584986},
                      {2.3530442258193771, -48.155285177680788, 23.0248512931569})};
  for (const auto& [a, b] : {std::pair<Index, Index>{0, 1}, {0, 2}, {1, 2}})
    bodies.contact.push_back(
        {.a = {a, 0},
         .b = {b, 0},
         .law = contact::state(contact::WaltonBraun(37571552.717368335, 117494982.93194853)),
         .tangential = {model::TangentialLaw::rigid, 0.28177505503595773, 0},
         .share = 1});
  bodies.named = 3;
  return bodies;
}

}  // namespace

// What was left of the slip where it came to rest is opposite to the slip that begins. Counted as slip, it
// made the direction of friction turn about within 10⁻¹⁸ s, which BDF and Adams could not follow.
BOOST_AUTO_TEST_CASE(a_slip_begins_whichever_way_the_last_one_has_ended) {
  const auto best = impact::simulate(ring(), {.accuracy = 1e-12});
  for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
    const auto one = impact::simulate(ring(), {.accuracy = accuracy});
    BOOST_TEST((one.ending == hybrid::Ending::separated), one.message);
    for (std::size_t i = 0; i < 3; ++i) {
      BOOST_TEST(norm(one.body[i].velocity - best.body[i].velocity) < accuracy);
      BOOST_TEST(0.01 * norm(one.body[i].spin - best.body[i].spin) < 10 * accuracy);
    }
  }
}
