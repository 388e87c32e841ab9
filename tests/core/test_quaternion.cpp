#define BOOST_TEST_MODULE core_quaternion
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/core/quaternion.hpp"

using namespace mariotte;

namespace {

constexpr double degree = std::numbers::pi / 180;

double apart(const Quaternion& p, const Quaternion& q) {  // q and −q are one rotation
  return 1 - std::abs(p.w * q.w + p.x * q.x + p.y * q.y + p.z * q.z);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_turn_in_the_plane_is_one_angle_however_far_it_goes) {
  for (const double beta : {-170.0, -91.0, -42.0, 0.0, 33.0, 89.0, 91.0, 146.8, 179.0}) {
    const auto angles = to_euler(rotation({0, 1, 0}, beta * degree));
    BOOST_TEST(std::abs(angles.alpha) < 1e-12, beta);
    BOOST_TEST(std::abs(angles.beta - beta * degree) < 1e-12, beta);
    BOOST_TEST(std::abs(angles.gamma) < 1e-12, beta);
  }
}

BOOST_AUTO_TEST_CASE(angles_describe_the_rotation_they_were_taken_from) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    Quaternion q{normal(random), normal(random), normal(random), normal(random)};
    q = (1 / std::sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z)) * q;
    BOOST_TEST(apart(from_euler(to_euler(q)), q) < 1e-14);
  }
}
