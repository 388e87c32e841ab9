// What is derived from the fields of contacts on curves, beside those of powers, agrees with them.
#define BOOST_TEST_MODULE field of contacts on curves
#include <boost/test/unit_test.hpp>

#include "mariotte/flow/taylor/row_fields.hpp"
#include "support/field_checks.hpp"

using namespace mariotte::flow::taylor;
using namespace mariotte::test;
using Q = CurveQuantities;

namespace {

template <Pace pace, Terms terms>
Case<CurveField<pace, terms>, double> some_case() {
  Case<CurveField<pace, terms>, double> made{.start = {0.7, 0.5, 0.1, 0.1, 0.9, 0.1}, .parameters = {}};
  auto& p = made.parameters;
  p[Q::stiffness] = 1.1, p[Q::steepening] = 0.3, p[Q::damping] = 0.2, p[Q::stiffening] = 0.15;
  p[Q::ring] = 0.05, p[Q::power] = 0.5, p[Q::curved] = 1, p[Q::free] = 1, p[Q::strength] = 1;
  p[Q::from] = 0.4, p[Q::push0] = 0.6, p[Q::push1] = 2.1, p[Q::push2] = -0.7, p[Q::push3] = 0.9;
  made.exponent = Q::power;
  return made;
}

}  // namespace

BOOST_AUTO_TEST_CASE(everything_agrees_with_elastic_contacts) {
  check<CurveField<Pace::plain, Terms::elastic>>(some_case<Pace::plain, Terms::elastic>());
  check<CurveField<Pace::landing, Terms::elastic>>(some_case<Pace::landing, Terms::elastic>());
}

BOOST_AUTO_TEST_CASE(everything_agrees_with_damped_contacts) {
  check<CurveField<Pace::plain, Terms::mixed>>(some_case<Pace::plain, Terms::mixed>());
  check<CurveField<Pace::landing, Terms::mixed>>(some_case<Pace::landing, Terms::mixed>());
  check<CurveField<Pace::general, Terms::mixed>>(some_case<Pace::general, Terms::mixed>());
}
