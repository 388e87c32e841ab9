// Short rows in the registers of every machine.
#define BOOST_TEST_MODULE short rows in lanes
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <vector>

#include "mariotte/flow/short_row/short_row_lanes.hpp"

using namespace mariotte;
using namespace mariotte::flow;

namespace {

/// Balls of mass 1 and contacts of stiffness `ratio`ʲ; the first strikes at a speed of 1.
ShortRow row(int contacts, double ratio, double gap) {
  ShortRow one{.contacts = contacts, .noise_speed = 1e-11, .same_instant = 1e-10};
  for (int j = 0; j < contacts; ++j) {
    one.own[j] = 2 * std::pow(ratio, j);
    one.from_left[j] = j > 0 ? std::pow(ratio, j - 1) : 0;
    one.from_right[j] = j + 1 < contacts ? std::pow(ratio, j + 1) : 0;
    one.weight[j] = 1;
    one.acts_above[j] = 1e-9;
    one.indentation[j] = j > 0 ? -gap : 0;
  }
  one.rate[0] = 1;
  begin(one);
  return one;
}

std::vector<ShortRow> many(int contacts) {
  std::vector<ShortRow> all;
  for (const double ratio : {0.5, 0.9, 1.3, 2.0})
    for (const double gap : {0.0, 0.05, 1.0}) all.push_back(row(contacts, ratio, gap));
  return all;
}
void follow(ShortRowLanes& lanes, std::vector<ShortRow>& rows) {
  std::vector<ShortRow*> pushing;
  for (auto& one : rows)
    if (one.stage == RowStage::pushes) pushing.push_back(&one);
  lanes.follow(pushing, {.tolerance = 1e-13, .order = 18});
}

/// Twice that of all balls; the mass centre moves at 1/(contacts + 1).
double energy(const ShortRow& r) {
  double moved = 0;
  for (int j = 0; j < r.contacts; ++j) moved += (r.contacts - j) * r.rate[j];
  double velocity = (1 + moved) / (r.contacts + 1), all = velocity * velocity;
  for (int j = 0; j < r.contacts; ++j) velocity -= r.rate[j], all += velocity * velocity;
  return all;
}

void expect_same(ShortRowLanes& lanes, const std::vector<ShortRow>& expected) {
  const int contacts = expected.front().contacts;
  auto rows = many(contacts);
  follow(lanes, rows);
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (int j = 0; j < contacts; ++j) {
      BOOST_TEST(std::abs(rows[i].rate[j] - expected[i].rate[j]) < 1e-11);
      BOOST_TEST(rows[i].periods[j] == expected[i].periods[j]);
    }
}

}  // namespace

BOOST_AUTO_TEST_CASE(energy_is_kept_and_nothing_approaches_at_the_end) {
  for (int contacts = 2; contacts <= ShortRow::most; ++contacts) {
    auto rows = many(contacts);
    follow(*make_short_row_lanes(contacts), rows);
    for (const auto& one : rows) {
      BOOST_TEST((one.stage == RowStage::over));
      BOOST_TEST(std::abs(energy(one) - 1) < 1e-10);
      for (int j = 0; j < contacts; ++j) {
        BOOST_TEST(one.rate[j] <= one.noise_speed);
        BOOST_TEST(one.indentation[j] <= 0);
        BOOST_TEST((one.role[j] != RowRole::closed));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(lanes_of_every_kind_give_the_same) {
  for (const int contacts : {4, 5, 8}) {
    auto expected = many(contacts);
    follow(*baseline::make_short_row_lanes(contacts), expected);
    for (const int room : {contacts, ShortRow::most}) {
      expect_same(*make_short_row_lanes(room), expected);
#ifdef __x86_64__
      if (has_avx2()) expect_same(*avx2::make_short_row_lanes(room), expected);
#endif
    }
  }
}
