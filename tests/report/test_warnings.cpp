// What is said of errors that have grown.
#define BOOST_TEST_MODULE report_warnings
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/report/warnings.hpp"

using namespace mariotte;

namespace {

using Periods = std::vector<impact::Period>;

/// All warnings of a result whose contacts were closed so, and whose error is larger than was asked.
template <class Impact, class History>
std::string said(const std::vector<Periods>& contacts, Impact impact) {
  for (const auto& periods : contacts) {
    History history{};
    history.periods = periods;
    impact.contacts.push_back(history);
  }
  impact.events.resize(1);
  impact.requested_accuracy = 1e-10;
  impact.estimated_accuracy = 1e-9;
  std::string all;
  for (const auto& one : report::warnings(impact, {})) all += one;
  return all;
}
std::string of_row(const std::vector<Periods>& contacts) {
  return said<impact::ChainImpact, impact::ContactHistory>(contacts, {});
}
std::string of_bodies(const std::vector<Periods>& contacts, double lost_digits) {
  impact::BodiesImpact impact;
  impact.lost_digits = lost_digits;
  return said<impact::BodiesImpact, impact::BodyContactHistory>(contacts, impact);
}

bool has(const std::string& text, const std::string& part) {
  BOOST_TEST_INFO(text);
  return text.find(part) != std::string::npos;
}

constexpr const char* close_often = "contacts close so often";
constexpr const char* fly_long = "after a flight so long";
constexpr const char* add_up = "the errors of all steps, and rounding, add up";
constexpr const char* lose_digits = "digits are lost";

}  // namespace

BOOST_AUTO_TEST_CASE(contacts_that_close_again_and_again_are_blamed) {
  BOOST_TEST(has(of_row({{{0, 1}, {2, 3}, {4, 5}}, {{1, 2}}}), close_often));
  BOOST_TEST(has(of_bodies({{{0, 1}, {2, 3}}}, 1e-9), close_often));
}

BOOST_AUTO_TEST_CASE(contacts_that_stay_closed_are_not) {
  BOOST_TEST(has(of_row({{{0, {}}}, {{0, {}}}}), add_up));
  BOOST_TEST(has(of_row({{{0, 1}, {2, 3}}, {{0.5, 1.5}, {2.5, 3.5}}}), add_up));  // a wave there and back
  BOOST_TEST(has(of_bodies({{{0, {}}}}, 0), add_up));
}

BOOST_AUTO_TEST_CASE(a_long_flight_is_told) {
  const std::vector<Periods> flight{{{0, 1}, {100, 101}}, {{100.5, 102}}};
  BOOST_TEST(has(of_row(flight), fly_long));
  BOOST_TEST(has(of_bodies({{{0, 1}}, {{100, 101}}, {{100.5, 102}}}, 0), fly_long));
}

BOOST_AUTO_TEST_CASE(digits_that_bodies_have_lost_on_their_way_are_told) {
  BOOST_TEST(has(of_bodies({{{0, 1}}}, 1e-9), lose_digits));
  BOOST_TEST(has(of_bodies({{{0, 1}}}, 1e-11), add_up));
}

BOOST_AUTO_TEST_CASE(a_body_that_strikes_once_has_not_closed_often) {
  impact::MicrobodyImpact impact;
  impact.requested_accuracy = 1e-10;
  impact.estimated_accuracy = 1e-9;
  impact.impacts.resize(1);
  BOOST_TEST(has(report::warnings(impact, {}).front(), add_up));
  impact.impacts.resize(2);
  BOOST_TEST(has(report::warnings(impact, {}).front(), close_often));
}

// Above critical damping an indentation sinks towards zero for ever.
BOOST_AUTO_TEST_CASE(contacts_that_fade_are_told) {
  const auto of_pair = [](double damping, double accuracy) {
    const model::Chain pair{
        .mass = {1, 1},
        .law = {contact::uncut(contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = 1})},
        .gap = {0},
        .velocity = {1, 0}};
    const auto network =
        report::warnings(impact::simulate(model::as_network(pair), {.accuracy = accuracy}), {});
    const auto chain = report::warnings(impact::simulate(pair, {.accuracy = accuracy}), {});
    BOOST_TEST(chain == network, boost::test_tools::per_element());
    return chain;
  };
  for (const double accuracy : {1e-6, 1e-10, 1e-12}) {
    BOOST_TEST(of_pair(0.5, accuracy).empty());
    const auto told = of_pair(3, accuracy);
    BOOST_TEST_REQUIRE(told.size() == 1u);
    BOOST_TEST(has(told[0], "contact 1 faded"));
    BOOST_TEST(has(told[0], "the time of its opening depends on the accuracy"));
  }
}
