#define BOOST_TEST_MODULE report_label_places
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/report/figure/label_places.hpp"

using namespace mariotte;

BOOST_AUTO_TEST_CASE(words_with_room_stay_where_they_are) {
  BOOST_TEST(report::spread({0.9, 0.1, 0.5}, {0.1, 0.1, 0.1}) == (std::vector<double>{0.9, 0.1, 0.5}),
             boost::test_tools::tolerance(1e-12) << boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(words_at_one_height_move_apart_evenly) {
  const auto places = report::spread({0.5, 0.5, 0.5}, {0.1, 0.1, 0.1});
  BOOST_TEST(places == (std::vector<double>{0.4, 0.5, 0.6}), boost::test_tools::tolerance(1e-12)
                                                                 << boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(no_two_words_cover_each_other_whatever_their_heights) {
  std::mt19937 dice(1);
  std::uniform_real_distribution<double> anywhere(0, 1);
  for (std::size_t count = 0; count <= 12; ++count)
    for (int repeat = 0; repeat < 100; ++repeat) {
      std::vector<double> wanted(count);
      for (auto& one : wanted) one = anywhere(dice) < 0.3 ? 0 : anywhere(dice);
      const auto places = report::spread(wanted, std::vector<double>(count, 0.08));
      for (std::size_t i = 0; i < count; ++i) {
        BOOST_TEST((places[i] > -1e-12 && places[i] < 1 + 1e-12));
        for (std::size_t k = 0; k < i; ++k) {
          BOOST_TEST(std::abs(places[i] - places[k]) > 0.08 - 1e-12);
          if (wanted[i] != wanted[k]) BOOST_TEST((wanted[i] < wanted[k]) == (places[i] < places[k]));
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(a_word_goes_above_those_that_take_its_place_or_else_below) {
  const report::Box box{0.2, 0.5, 0.3, 0.1};
  BOOST_TEST(report::free_place(box, {}).y == 0.5);
  BOOST_TEST(report::free_place(box, {{0.4, 0.5, 0.3, 0.1}}).y == 0.6, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(report::free_place(box, {{0, 0.5, 1, 0.5}}).y <= 0.4);
}

BOOST_AUTO_TEST_CASE(a_word_leaves_curves_free_by_the_shortest_way) {
  const report::Box box{0.2, 0.5, 0.3, 0.1};
  const auto beside = report::free_place(box, {}, {{0.2, 0, 0.02, 1}});
  BOOST_TEST((beside.y == 0.5 && beside.x > 0.22 && beside.x < 0.3));
  BOOST_TEST(report::free_place(box, {}, {{0, 0.52, 1, 0.01}}).y > 0.53);
  BOOST_TEST(report::free_place(box, {}, {{0, 0, 1, 1}}).y == 0.5);  // there is no such place
}

BOOST_AUTO_TEST_CASE(words_of_events_never_cover_each_other_at_any_number) {
  for (const int count : {1, 2, 10, 100, 10'000}) {
    std::vector<double> at, width(static_cast<std::size_t>(count), 0.1);
    for (int i = 0; i < count; ++i) at.push_back(static_cast<double>(i) / count);
    const auto row = report::rows_of_words(at, width, 2);
    BOOST_TEST(row[0] == 0);
    int covered = 0;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t k = i; k-- > 0 && at[i] - at[k] < 0.1;) covered += row[i] >= 0 && row[i] == row[k];
    BOOST_TEST(covered == 0);
  }
}
