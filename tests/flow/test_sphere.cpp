// The field of a sphere, and its series in the registers of every machine.
#define BOOST_TEST_MODULE spheres in lanes
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "mariotte/flow/lanes/lane_precision.hpp"
#include "mariotte/flow/sphere/sphere_field.hpp"
#include "mariotte/flow/sphere/sphere_lanes.hpp"
#include "support/field_checks.hpp"

using namespace mariotte;
using namespace mariotte::flow;
using boost::test_tools::tolerance;

namespace {

Sphere sphere(double adhesion, double damping_hertz, double damping_adhesion) {
  return {.adhesion = adhesion,
          .damping_hertz = damping_hertz,
          .damping_adhesion = damping_adhesion,
          .weight = 1 + adhesion,
          .noise_energy = 1e-12,
          .rate = 1};
}

std::vector<Sphere> many() {
  std::vector<Sphere> all;
  for (const double adhesion : {0.0, 0.02, 0.3, 1.0, 3.0})
    for (const double damping : {0.0, 1e-3, 0.2, 2.0})
      all.push_back(sphere(adhesion, damping, 0.3 * damping));
  return all;
}

void follow(std::vector<Sphere>& spheres, double accuracy,
            std::unique_ptr<SphereLanes> lanes = make_sphere_lanes()) {
  std::vector<Sphere*> all;
  for (auto& one : spheres) all.push_back(&one);
  lanes->follow(all, lane_precision(accuracy, sphere_orders));
}

}  // namespace

BOOST_AUTO_TEST_CASE(everything_agrees_with_a_sphere_in_contact) {
  test::check<SphereField>({{0.7, -0.4, 1}, {0.3, 0.1, 0.2}});
}

BOOST_AUTO_TEST_CASE(without_damping_a_sphere_leaves_as_quickly_as_it_came) {
  for (const double accuracy : {1e-4, 1e-7, 1e-10, 1e-13}) {
    std::vector<Sphere> spheres;
    for (const double adhesion : {0.0, 1e-3, 0.1, 1.0, 4.0}) spheres.push_back(sphere(adhesion, 0, 0));
    follow(spheres, accuracy);
    for (const auto& one : spheres) {
      BOOST_TEST(one.separates);
      BOOST_TEST(std::abs(one.rate + 1) < accuracy);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_hertz_contact_takes_its_known_time) {
  std::vector<Sphere> one{sphere(0, 0, 0)};
  follow(one, 1e-13);
  // 2 (5/4)^{2/5} Γ(7/5) √π / Γ(9/10), the duration for unit mass, stiffness and speed.
  const double duration = 2 * std::pow(1.25, 0.4) * std::tgamma(1.4) * std::sqrt(M_PI) / std::tgamma(0.9);
  BOOST_TEST(one[0].time == duration, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(lanes_of_every_kind_give_the_same) {
  for (const double accuracy : {1e-6, 1e-12}) {
    auto expected = many(), all = many();
    follow(expected, accuracy, baseline::make_sphere_lanes());
    follow(all, accuracy);
    for (std::size_t i = 0; i < all.size(); ++i) {
      BOOST_TEST(all[i].separates == expected[i].separates);
      if (!all[i].separates) continue;
      BOOST_TEST(all[i].rate == expected[i].rate, tolerance(1e-13));
      BOOST_TEST(all[i].time == expected[i].time, tolerance(1e-13));
    }
  }
}

BOOST_AUTO_TEST_CASE(what_adhesion_holds_does_not_leave) {
  std::vector<Sphere> spheres{sphere(3, 0.2, 0.06), sphere(3, 0, 0), sphere(1, 2, 0.6)};
  follow(spheres, 1e-9);
  BOOST_TEST(!spheres[0].separates);
  BOOST_TEST(spheres[1].separates);
  BOOST_TEST(!spheres[2].separates);
}
