// Bodies in contact by series beside CVODE, which shares their field but neither clocks nor polynomials.
#include <algorithm>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "support/flow_steps.hpp"
#include "support/meeting_bodies.hpp"

using namespace mariotte;
using model::TangentialLaw;
using support::Scenes;

namespace {

/// Contacts that close.
Index closed(const impact::BodiesImpact& impact) {
  return std::count_if(impact.contacts.begin(), impact.contacts.end(),
                       [](const auto& one) { return !one.periods.empty(); });
}

hybrid::Options options(double accuracy, std::optional<flow::Kind> kind) {
  hybrid::Options options;
  options.accuracy = accuracy;
  options.flow = kind;
  return options;
}

/// What adheres may stay so.
hybrid::Options until(bool branched, hybrid::Options options) {
  if (branched) options.max_time = 0.04;
  return options;
}

double difference(const impact::BodiesImpact& a, const impact::BodiesImpact& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.body.size(); ++i)
    most = std::max(
        {most, norm(a.body[i].velocity - b.body[i].velocity), 0.02 * norm(a.body[i].spin - b.body[i].spin)});
  return most;
}

void compare(int dimension, unsigned seed, int count, bool branched = false) {
  Scenes scenes(seed, branched);
  int met = 0;
  Index series = 0, cvode = 0, left = 0;
  for (int i = 0; i < count; ++i) {
    const auto bodies = scenes.next(dimension);
    const auto run = [&](flow::Kind kind) {
      return impact::simulate(bodies, until(branched, options(1e-9, kind)));
    };
    const auto one = run(flow::Kind::taylor), two = run(flow::Kind::cvode_adams);
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_CHECK(one.ending == two.ending);
      BOOST_TEST(difference(one, two) < 1e-7);
      BOOST_TEST(closed(one) == closed(two));
    }
    met += !one.contacts.empty();
    series += test::steps(one, flow::Kind::taylor);
    left += test::steps(one, flow::Kind::cvode_adams);
    cvode += test::steps(two, flow::Kind::cvode_adams);
  }
  BOOST_TEST(2 * met > count);
  BOOST_TEST(series > 0);
  if (dimension == 2) BOOST_TEST(series < cvode / 3);
  if (branched && dimension == 2) BOOST_TEST(left == 0);
}

}  // namespace

BOOST_AUTO_TEST_CASE(series_agree_with_cvode_in_the_plane) {
  compare(2, 1, 15);
}

BOOST_AUTO_TEST_CASE(series_of_laws_with_branches_agree_with_cvode) {
  compare(2, 5, 60, true);
  compare(3, 6, 20, true);
}

BOOST_AUTO_TEST_CASE(series_agree_with_cvode_in_space) {
  compare(3, 2, 8);
}

/// Balls that are stated to touch and stand a fiftieth of their radius apart: all flows turn them about
/// centres at that distance.
BOOST_AUTO_TEST_CASE(what_is_stated_to_touch_does_so_where_it_stands) {
  constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;
  for (const int balls : {2, 3}) {  // a pair, and a cluster
    model::Bodies bodies{.dimension = 2};
    for (int i = 0; i < balls; ++i) {
      model::Body one{.name = "", .mass = mass, .inertia = {moment, moment, moment}};
      one.spheres = {{{}, radius}};
      one.position = {2.02 * radius * i, 0.005 * (i == 2), 0};
      if (i == 0) one.velocity = {1, 0.4, 0}, one.spin = {0, 0, 30};
      bodies.body.push_back(one);
      if (i > 0)
        bodies.contact.push_back({.a = {i - 1, 0},
                                  .b = {i, 0},
                                  .law = contact::Hertz(1e7),
                                  .tangential = {TangentialLaw::spring, 0.3, 1e4},
                                  .touching = true});
    }
    const auto series = impact::simulate(bodies, options(1e-10, {})),
               cvode = impact::simulate(bodies, options(1e-11, flow::Kind::cvode_adams));
    BOOST_TEST(series.contacts.size() == cvode.contacts.size());
    BOOST_TEST(difference(series, cvode) < 1e-9);
  }
}

/// Loads 1 + a δ̇ fade to rounding while contacts push, and must not come and go by it.
BOOST_AUTO_TEST_CASE(faded_loads_make_no_events) {
  constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;
  model::Bodies bodies{.dimension = 2, .gravity = {0, -9.81, 0}};
  bodies.plane = {{.name = "", .point = {0, -0.01001, 0}, .normal = {0, 1, 0}}};
  for (int i = 0; i < 2; ++i) {
    model::Body one{.name = "", .mass = mass, .inertia = {moment, moment, moment}};
    one.spheres = {{{}, radius}};
    one.position = {0.01976 * i, 0.0031 * i, 0};
    one.velocity = i == 0 ? Vector3{0.167, 0.034, 0} : Vector3{-0.335, -0.106, 0};
    one.spin = {0, 0, i == 0 ? 4.8 : -8.1};
    bodies.body.push_back(one);
    bodies.contact.push_back({.a = {0, -1}, .b = {i, 0}});
  }
  bodies.contact.push_back({.a = {0, 0}, .b = {1, 0}});
  for (auto& contact : bodies.contact) {
    contact.law = std::make_shared<contact::HuntCrossley>(1.8e7, 3460, 1.5);
    contact.tangential = {TangentialLaw::spring, 0.7, 1.4e7};
  }
  const auto run = [&](double accuracy, std::optional<flow::Kind> kind) {
    auto asked = options(accuracy, kind);
    asked.max_time = 0.02;
    return impact::simulate(bodies, asked);
  };
  const auto cvode = run(1e-10, flow::Kind::cvode_adams);
  for (const double accuracy : {1e-8, 1e-10, 1e-12}) {
    const auto series = run(accuracy, {});
    BOOST_TEST(series.events.size() < 40);
    BOOST_TEST(difference(series, cvode) < 1e-7);
  }
}

/// Fifteen balls have 105 pairs: only near ones are watched, and nothing is missed.
BOOST_AUTO_TEST_CASE(pairs_that_are_far_apart_need_not_be_watched) {
  Scenes scenes(3);
  model::Bodies bodies{.dimension = 2};
  constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;
  for (int row = 0; row < 5; ++row)
    for (int place = 0; place <= row; ++place) {
      model::Body one{.name = "", .mass = mass, .inertia = {moment, moment, moment}};
      one.spheres = {{{}, radius}};
      one.position = {0.0176 * row, 0.0203 * (place - 0.5 * row) + 2e-4 * scenes.in(-1, 1), 0};
      one.velocity = {row == 0 ? 2.0 : 0.0, row == 0 ? 0.1 : 0.0, 0};
      bodies.body.push_back(one);
    }
  for (Index a = 0; a < std::ssize(bodies.body); ++a)
    for (Index b = a + 1; b < std::ssize(bodies.body); ++b)
      bodies.contact.push_back({.a = {a, 0},
                                .b = {b, 0},
                                .law = contact::Hertz(1e9),
                                .tangential = {TangentialLaw::mindlin, 0.2, 1e9}});
  const auto one = impact::simulate(bodies, options(1e-8, flow::Kind::taylor));
  std::vector<char> closes(bodies.contact.size(), 0);
  for (const auto& contact : one.contacts) closes[contact.contact] = !contact.periods.empty();
  auto few = bodies;  // so few that all are watched all the time: neighbours, and whatever meets
  few.contact.clear();
  for (std::size_t i = 0; i < bodies.contact.size(); ++i) {
    const auto& c = bodies.contact[i];
    const double apart = norm(bodies.body[c.a.owner].position - bodies.body[c.b.owner].position);
    if (closes[i] || apart < 0.03) few.contact.push_back(c);
  }
  BOOST_TEST(few.contact.size() <= 64u);
  const auto two = impact::simulate(few, options(1e-8, flow::Kind::cvode_adams));
  BOOST_CHECK(one.ending == hybrid::Ending::separated);
  BOOST_TEST(closed(one) == closed(two));
  BOOST_TEST(difference(one, two) < 1e-5);
}

/// With a pair far away that touches at rest: of balls, so that each phase is a cluster, or of rods, so that
/// it is recorded.
model::Bodies beside(model::Bodies bodies, bool rods) {
  const Index first = std::ssize(bodies.body);
  for (const double place : {1.0, 1.02}) {
    bodies.body.push_back(bodies.body[0]);
    bodies.body.back().position = {place, 1, 0};
    bodies.body.back().velocity = bodies.body.back().spin = {};
    if (rods) bodies.body.back().spheres = {{{0, 0.005, 0}, 0.01}};
  }
  bodies.contact.push_back(
      {.a = {first, 0}, .b = {first + 1, 0}, .law = contact::Hertz(1e9), .touching = true});
  return bodies;
}

/// Number of contacts that have closed.
int compare_to_the_last_digits(const impact::BodiesImpact& one, const impact::BodiesImpact& two) {
  BOOST_TEST(one.events.size() == two.events.size());
  for (std::size_t k = 0; k < one.body.size(); ++k) {
    BOOST_TEST(norm(one.body[k].velocity - two.body[k].velocity) < 1e-11);
    BOOST_TEST(0.02 * norm(one.body[k].spin - two.body[k].spin) < 1e-11);
  }
  int closed = 0;
  for (std::size_t c = 0; c < one.contacts.size(); ++c) {
    const auto &a = one.contacts[c], &b = two.contacts[c];
    BOOST_TEST(std::abs(a.peak_force - b.peak_force) <= 1e-7 * b.peak_force);
    BOOST_TEST(std::abs(a.peak_friction - b.peak_friction) <= 1e-7 * b.peak_force);
    BOOST_TEST(std::abs(a.losses.friction - b.losses.friction) < 1e-13);
    BOOST_TEST(std::abs(a.losses.rescale - b.losses.rescale) < 1e-13);
    closed += !a.periods.empty();
  }
  return closed;
}

BOOST_AUTO_TEST_CASE(one_contact_of_balls_goes_as_among_many) {
  Scenes scenes(4);
  int met = 0;
  for (int i = 0; i < 40; ++i) {
    auto bodies = scenes.next(2);
    for (auto& body : bodies.body) body.spheres = {{{}, 0.01}};
    std::erase_if(bodies.contact, [](const auto& c) { return c.a.sphere > 0 || c.b.sphere > 0; });
    for (auto& contact : bodies.contact) contact.law = contact::Hertz(1e9);
    const auto one = impact::simulate(bodies, options(1e-12, flow::Kind::taylor));
    const auto two = impact::simulate(beside(bodies, false), options(1e-12, flow::Kind::taylor));
    BOOST_TEST_CONTEXT("scene " << i) met += compare_to_the_last_digits(one, two);
  }
  BOOST_TEST(met > 20);
}

/// Three balls on a plane that touch all, or nearly; springs and linear laws among the laws.
BOOST_AUTO_TEST_CASE(several_contacts_of_balls_go_as_recorded_ones) {
  Scenes scenes(6);
  int met = 0;
  for (int i = 0; i < 20; ++i) {
    const auto bodies = scenes.heap();
    const auto one = impact::simulate(bodies, options(1e-11, flow::Kind::taylor));
    const auto two = impact::simulate(beside(bodies, true), options(1e-11, flow::Kind::taylor));
    BOOST_TEST_CONTEXT("scene " << i) met += compare_to_the_last_digits(one, two);
  }
  BOOST_TEST(met > 60);
}

/// Forces are polynomials of the steps, and their peaks roots of slopes; CVODE's are looked for.
BOOST_DATA_TEST_CASE(peaks_of_forces_are_those_of_cvode, boost::unit_test::data::make({false, true}),
                     branched) {
  for (const int dimension : {2, 3}) {
    Scenes scenes(5, branched);
    for (int i = 0; i < 12; ++i) {
      const auto bodies = scenes.next(dimension);
      const auto run = [&](flow::Kind kind) {
        return impact::simulate(bodies, until(branched, options(1e-9, kind)));
      };
      const auto one = run(flow::Kind::taylor), two = run(flow::Kind::cvode_adams);
      BOOST_TEST_CONTEXT("scene " << i << " in " << dimension << "D")
      for (std::size_t c = 0; c < one.contacts.size(); ++c) {
        const auto &a = one.contacts[c], &b = two.contacts[c];
        BOOST_TEST(std::abs(a.peak_force - b.peak_force) <= 1e-5 * b.peak_force);
        BOOST_TEST(std::abs(a.peak_friction - b.peak_friction) <= 1e-5 * b.peak_force);
        BOOST_TEST(std::abs(a.peak_indentation - b.peak_indentation) <= 1e-5 * b.peak_indentation);
      }
    }
  }
}

/// One ball swings under its weight and comes back to its plane at no depth, just as another one strikes it.
/// Its force there is lost in rounding, and is not to pass for its largest.
BOOST_AUTO_TEST_CASE(a_contact_that_hardly_touches_has_no_peak_there) {
  model::Bodies bodies{.dimension = 2, .gravity = {0, -1, 0}};
  const auto ball = [](const Vector3& position, const Vector3& velocity) {
    return model::Body{.name = "",
                       .mass = 1,
                       .inertia = {0.1, 0.1, 0.1},
                       .spheres = {{{}, 0.5}},
                       .position = position,
                       .velocity = velocity};
  };
  bodies.body = {
      ball({-0.2397127693021015, 0.4387912809451864, 0}, {0.4387912809451864, 0.2397127693021015, 0}),
      ball({2.249207254787756, 2.140342665324907, 0}, {0.2397127693021015, -0.4387912809451864, 0})};
  bodies.plane = {{.name = "", .normal = {-0.479425538604203, 0.8775825618903728, 0}}};
  for (const Index body : {0, 1})
    bodies.contact.push_back(
        {.a = {0, -1}, .b = {body, 0}, .law = contact::Hertz(1e4), .touching = body == 0});
  bodies.contact.push_back({.a = {0, 0}, .b = {1, 0}, .law = contact::Hertz(1e4)});
  for (const double accuracy : {1e-8, 1e-9, 1e-10, 1e-11}) {
    const auto impact = impact::simulate(bodies, {.accuracy = accuracy, .max_time = 1, .flies_on = true});
    for (const auto& one : impact.contacts) {
      const double expected = 1e4 * std::pow(one.peak_indentation, 1.5);
      BOOST_TEST(std::abs(one.peak_force - expected) <= 1e-6 * expected);
    }
  }
}

/// Balls of a rack that touches are pressed one after the other, at hardly any depth, and stick at once.
BOOST_AUTO_TEST_CASE(touching_balls_need_no_cvode) {
  model::Bodies bodies{.dimension = 2};
  constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;
  const auto add = [&](const Vector3& place, const Vector3& velocity) {
    bodies.body.push_back({.name = "",
                           .mass = mass,
                           .inertia = {moment, moment, moment},
                           .spheres = {{{}, radius}},
                           .position = place,
                           .velocity = velocity});
  };
  add({-0.03, 0.002, 0}, {2, 0, 0});
  for (int row = 0; row < 4; ++row)
    for (int place = 0; place <= row; ++place)
      add({std::sqrt(3) * radius * row, 2 * radius * (place - 0.5 * row), 0}, {});
  for (Index b = 1; b < std::ssize(bodies.body); ++b)
    for (Index a = 0; a < b; ++a)
      bodies.contact.push_back(
          {.a = {a, 0},
           .b = {b, 0},
           .law = contact::Hertz(1e9),
           .tangential = {TangentialLaw::mindlin, 0.1, 1e9},
           .touching = norm(bodies.body[a].position - bodies.body[b].position) < 2.001 * radius});
  const auto one = impact::simulate(bodies, options(1e-8, std::nullopt));
  const auto two = impact::simulate(bodies, options(1e-8, flow::Kind::cvode_adams));
  BOOST_CHECK(one.ending == hybrid::Ending::separated);
  BOOST_TEST(test::steps(one, flow::Kind::cvode_adams) == 0);
  BOOST_TEST(difference(one, two) < 1e-7);
}

/// Two balls touch for long, while a third comes from afar: its gap is no guard until it may close.
BOOST_AUTO_TEST_CASE(balls_that_come_from_afar_are_met) {
  constexpr double radius = 0.01, mass = 0.03, moment = 0.4 * mass * radius * radius;
  for (const bool compiled : {false, true}) {
    model::Bodies bodies{.dimension = 2};
    for (const auto& [place, velocity] :
         {std::pair{-0.0205, 0.2}, std::pair{0.0, 0.0}, std::pair{0.06, -4.0}})
      bodies.body.push_back({.name = "",
                             .mass = mass,
                             .inertia = {moment, moment, moment},
                             .spheres = {{{}, radius}},
                             .position = {place, 0.02 * place, 0},
                             .velocity = {velocity, 0, 0},
                             .spin = {0, 0, 40}});
    const contact::Law soft =
        compiled ? contact::Law(contact::Hertz(5e3)) : contact::Law(contact::Linear(50));
    const model::Tangential grip = compiled ? model::Tangential{TangentialLaw::mindlin, 0.3, 4e3}
                                            : model::Tangential{TangentialLaw::spring, 0.3, 40};
    for (const auto& [a, b] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}})
      bodies.contact.push_back(
          {.a = {a, 0},
           .b = {b, 0},
           .law = b == 2 ? contact::Law(contact::Hertz(1e9)) : soft,
           .tangential = b == 2 ? model::Tangential{TangentialLaw::mindlin, 0.3, 1e9} : grip});
    const auto one = impact::simulate(bodies, options(1e-9, flow::Kind::taylor));
    const auto two = impact::simulate(bodies, options(1e-9, flow::Kind::cvode_adams));
    BOOST_TEST_CONTEXT((compiled ? "compiled" : "recorded")) {
      BOOST_TEST_REQUIRE(closed(one) >= 2);
      BOOST_TEST(one.contacts[2].periods.front().start < one.contacts[0].periods.front().end.value());
      BOOST_TEST(closed(one) == closed(two));
      BOOST_TEST(difference(one, two) < 1e-7);
    }
  }
}
