#define BOOST_TEST_MODULE report_motion
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mariotte/core/overload.hpp"
#include "mariotte/report/page/animation.hpp"
#include "mariotte/report/page/motion.hpp"
#include "mariotte/scene/simulate.hpp"

using namespace mariotte;
using report::Json;

namespace {

/// The motion of a scene of the repository, and its trace by a visitor.
template <class Model, class Check>
void with(const std::string& name, const Check& check) {
  const auto scene = scene::read(std::string(MARIOTTE_SCENES) + "/" + name);
  const auto impact = impact::simulate(std::get<Model>(scene.model), scene.run, {.trace = true});
  check(report::motion(impact, scene), impact, scene);
}

double distance(const Json& motion, std::size_t frame, std::size_t a, std::size_t b) {
  const auto place = [&](std::size_t i, const char* axis, std::size_t k) {
    return motion["discs"][i][axis].get<double>() + motion["move"][frame][2 * i + k].get<double>();
  };
  return std::hypot(place(a, "x", 0) - place(b, "x", 0), place(a, "y", 1) - place(b, "y", 1));
}

/// Every row has a value for each disc or contact, at every instant.
void expect_whole(const Json& motion) {
  const auto frames = motion["time"].size();
  BOOST_TEST(frames > 200u);
  BOOST_TEST((motion["move"].size() == frames && motion["force"].size() == frames));
  for (std::size_t i = 0; i < frames; ++i) {
    BOOST_TEST(motion["move"][i].size() == 2 * motion["discs"].size());
    BOOST_TEST(motion["force"][i].size() == motion["contacts"].size());
    if (i > 0) BOOST_TEST(motion["time"][i].get<double>() > motion["time"][i - 1].get<double>());
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(balls_of_a_chain_approach_by_the_indentation_of_their_contact) {
  with<model::Chain>("newton_cradle_5.toml", [](const Json& motion, const auto& impact, const auto& scene) {
    expect_whole(motion);
    BOOST_TEST(motion["to_scale"] == true);
    double deepest = 0, strongest = 0;
    for (std::size_t i = 0; i < motion["time"].size(); ++i) {
      deepest = std::max(deepest, scene.radius[0] + scene.radius[1] - distance(motion, i, 0, 1));
      strongest = std::max(strongest, motion["force"][i][0].template get<double>());
    }
    // Frames are a 240th of the picture apart, and places are summed over the steps of the flow.
    BOOST_TEST(deepest == impact.contacts[0].peak_indentation, boost::test_tools::tolerance(1e-2));
    BOOST_TEST(strongest == impact.contacts[0].peak_force, boost::test_tools::tolerance(1e-3));
  });
}

BOOST_AUTO_TEST_CASE(balls_in_the_plane_lie_where_the_scene_puts_them) {
  with<model::Network>("rack_of_fifteen.toml", [](const Json& motion, const auto& impact, const auto& scene) {
    expect_whole(motion);
    for (const auto& contact : motion["contacts"]) {
      const std::size_t a = contact["from"], b = contact["to"];
      BOOST_TEST(distance(motion, 0, a, b) > (1 - 1e-9) * (scene.radius[a] + scene.radius[b]));
    }
    const auto last = motion["time"].size() - 1;
    const double step =
        motion["time"][last].template get<double>() - motion["time"][last - 1].template get<double>();
    for (std::size_t k = 0; k < impact.velocity.size(); ++k) {
      const double moved =
          motion["move"][last][k].template get<double>() - motion["move"][last - 1][k].template get<double>();
      BOOST_TEST(std::abs(moved / step - impact.velocity[k]) < 1e-2 * 8);  // of the cue ball's speed
    }
  });
}

BOOST_AUTO_TEST_CASE(tips_of_a_body_keep_their_distance_and_press_on_the_plane) {
  with<model::Microbody>("microrod.toml", [](const Json& motion, const auto& impact, const auto& scene) {
    expect_whole(motion);
    BOOST_TEST(motion["floor"] == true);
    BOOST_TEST((motion["links"] == Json{{0, 1}}));
    const auto& tips = std::get<model::Microbody>(scene.model).body.tips;
    const double length = tips[1].centre.e1 - tips[0].centre.e1;
    double strongest = 0;
    for (std::size_t i = 0; i < motion["time"].size(); ++i) {
      BOOST_TEST(distance(motion, i, 0, 1) == length,
                 boost::test_tools::tolerance(1e-4));  // five digits of places
      strongest = std::max(strongest, motion["force"][i][0].template get<double>());
    }
    BOOST_TEST(strongest == impact.impacts[0].peak_force, boost::test_tools::tolerance(1e-2));
  });
}

BOOST_AUTO_TEST_CASE(a_fall_is_left_out_and_a_window_of_ones_own_is_shown) {
  with<model::Chain>("column_on_a_wall.toml", [](const Json& motion, const auto& impact, const auto& scene) {
    BOOST_TEST(motion["time"][0].template get<double>() > 0.9 * impact.events[0].time);
    BOOST_TEST(motion["discs"][0]["radius"].is_null());
    auto chosen = scene;
    chosen.figure.window = {{0.01, 0.02}};
    const auto fall = report::motion(impact, chosen);
    BOOST_TEST((fall["time"].front() == 0.01 && fall["time"].back() == 0.02));
    BOOST_TEST(fall["move"].back()[2].template get<double>() == -9.81 * 0.5 * (4e-4 - 1e-4),
               boost::test_tools::tolerance(1e-3));
  });
}

// Each lasts a small part of what is shown.
BOOST_AUTO_TEST_CASE(short_impacts_have_frames_and_the_largest_force_is_one) {
  for (const auto* name : {"coin.toml", "settling_column.toml", "climbing_dumbbell.toml"})
    with<model::Bodies>(name, [&](const Json& motion, const auto& impact, const auto&) {
      expect_whole(motion);
      double shown = 0, strongest = 0;
      for (const auto& row : motion["force"])
        for (const double f : row) shown = std::max(shown, f);
      for (const auto& contact : impact.contacts) strongest = std::max(strongest, contact.peak_force);
      BOOST_TEST(shown == strongest, boost::test_tools::tolerance(1e-2));
    });
}

BOOST_AUTO_TEST_CASE(corners_of_a_block_have_an_outline_and_planes_stand_where_they_are) {
  with<model::Bodies>("climbing_dumbbell.toml", [](const Json& motion, const auto&, const auto& scene) {
    const auto& planes = std::get<model::Bodies>(scene.model).plane;
    BOOST_TEST(motion["planes"].size() + (motion["floor"] == true) == planes.size());
    const auto is_friction = [](const Json& contact) { return contact.contains("same_as"); };
    BOOST_TEST(std::count_if(motion["contacts"].begin(), motion["contacts"].end(), is_friction) > 0);
  });
  with<model::Bodies>("rocking_with_friction.toml", [](const Json& motion, const auto&, const auto&) {
    BOOST_TEST((motion["outlines"] == Json{{0, 1, 2, 3}}));
    BOOST_TEST(motion["links"].empty());
  });
}

// A groove along y, in space, is seen along y.
BOOST_AUTO_TEST_CASE(planes_in_space_are_seen_as_lines) {
  const auto scene = scene::parse(R"(
[bodies]
dimension = 3
law = "hertz"
stiffness = 1e6
radius = 0.05
mass = 0.2
[[bodies.body]]
position = [0, 0, 0.08]
velocity = [0, 0.5, -1]
[[bodies.plane]]
normal = [1, 0, 1]
[[bodies.plane]]
normal = [-1, 0, 1]
)",
                                  "groove");
  const auto impact = impact::simulate(std::get<model::Bodies>(scene.model), scene.run, {.trace = true});
  const auto motion = report::motion(impact, scene);
  BOOST_TEST((motion["axes"] == Json{"x", "z"}));
  BOOST_TEST(motion["planes"].size() == 2u);
  BOOST_TEST(motion["discs"][0]["y"].get<double>() > 0.05);
}

// The size of a ball is not known, but where it touches a wall.
BOOST_AUTO_TEST_CASE(balls_of_unknown_size_stand_beside_their_wall) {
  const auto scene = scene::parse(
      "[chain]\nmass = 1\nballs = 1\nwall = 'left'\ngap = 1e-3\nvelocity = -1\nlaw = 'hertz'\nstiffness = "
      "1e5\n",
      "wall");
  const auto impact = impact::simulate(std::get<model::Chain>(scene.model), scene.run, {.trace = true});
  const auto discs = report::motion(impact, scene)["discs"];
  const double radius = discs[1]["radius"], apart = discs[1]["x"].get<double>() - discs[0]["x"].get<double>();
  BOOST_TEST(discs[0]["radius"].is_null());
  BOOST_TEST(apart == radius + 1e-3, boost::test_tools::tolerance(1e-12));
}

// A rod of which one end touches: the other side of its mass centre is not known.
BOOST_AUTO_TEST_CASE(a_point_beside_its_mass_is_seen_with_it) {
  with<model::Bodies>("painleve_rod.toml", [](const Json& motion, const auto&, const auto&) {
    BOOST_TEST(motion["discs"].size() == 2u);
    BOOST_TEST((motion["links"] == Json{{0, 1}}));
  });
}

BOOST_AUTO_TEST_CASE(what_has_no_places_has_no_moving_picture) {
  with<model::Network>("rocking_block.toml",
                       [](const Json& motion, const auto&, const auto&) { BOOST_TEST(motion.empty()); });
  BOOST_TEST(report::animation({}, {{"points", 3}}) == "");
  const Json row = {{"model", "chain"}, {"final", {{"velocity", std::vector<double>(200)}}}};
  BOOST_TEST(report::animation({}, row).find("none of 200 bodies: of more than 100 each") !=
             std::string::npos);
  const Json other = {{"model", "network"}, {"final", {{"velocity", {1, 2}}}}};
  BOOST_TEST(report::animation({}, other).find("<p>There is none of this run: it shows balls and bodies") !=
             std::string::npos);
}
