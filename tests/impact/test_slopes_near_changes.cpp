// Notes of slopes next to where other numbers lead to another order of events.
#define BOOST_TEST_MODULE impact_slopes_near_changes
#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/contact/walton_braun.hpp"
#include "mariotte/impact/sensitivity/sensitivity.hpp"

using namespace mariotte;

BOOST_AUTO_TEST_CASE(balls_that_touch_and_hardly_move_have_slopes_of_one_side) {
  const auto notes_of = [](double approach) {
    const model::Chain chain{.mass = {1, 1, 1},
                             .law = {contact::Linear{1}, contact::Linear{1}},
                             .gap = {0, 0},
                             .velocity = {1, approach, 0}};
    return impact::sensitivity(chain, impact::parameters(chain)).notes;
  };
  BOOST_TEST_REQUIRE(notes_of(1e-9).size() == 1u);
  BOOST_TEST(notes_of(1e-9)[0].text.starts_with("contact 2 touches at the start with 1e-09 m/s"));
  BOOST_TEST(notes_of(0.1).empty());
}

// It leaves the dent at half its speed, comes back from the other wall as fast, and turns where it did.
BOOST_AUTO_TEST_CASE(a_ball_that_returns_to_its_dent_says_that_it_nearly_yields) {
  const model::Chain chain{.mass = {infinity, 1, infinity},
                           .law = {contact::state(contact::WaltonBraun(1, 4)), contact::Hertz{1}},
                           .gap = {0.5, 1},
                           .velocity = {0, -1, 0}};
  const auto notes_until = [&](double time) {
    return impact::sensitivity(chain, impact::parameters(chain), {.accuracy = 1e-10, .max_time = time}).notes;
  };
  const auto is_near = [](const auto& note) { return note.text.starts_with("contact 1 turns "); };
  for (const auto& note : notes_until(5)) BOOST_TEST(!is_near(note), note.text);
  const auto notes = notes_until(20);
  BOOST_TEST(std::count_if(notes.begin(), notes.end(), is_near) == 1);
}

// It is thrown up and comes back from just below the ceiling.
BOOST_AUTO_TEST_CASE(a_ball_that_turns_next_to_a_wall_says_that_it_nearly_strikes) {
  const auto notes_below = [](double distance) {
    const model::Chain chain{.mass = {infinity, 1, infinity},
                             .law = {contact::Hertz{1e4}, contact::Hertz{100}},
                             .gap = {0, 0.5 + distance},
                             .velocity = {0, 1, 0},
                             .gravity = 1};
    return impact::sensitivity(chain, impact::parameters(chain), {.accuracy = 1e-10, .max_time = 3}).notes;
  };
  const auto is_near = [](const auto& note) {
    return note.text.starts_with("contact 2 turns 1e-09 m before it would close");
  };
  const auto notes = notes_below(1e-9);
  BOOST_TEST(std::count_if(notes.begin(), notes.end(), is_near) == 1);
  BOOST_TEST(notes_below(1e-5).empty());
}
