// The same impact by series and by Adams, which asks the laws themselves.
#pragma once
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/flow_steps.hpp"
#include "support/reference.hpp"

namespace mariotte::test {

/// Compares one model after the other, and counts.
struct SeriesAgainstAdams {
  Index series = 0, adams = 0;  ///< steps

  /// Series alone may follow it, to this accuracy.
  template <class Model>
  void compare(const Model& model, double accuracy, double max_time = 100) {
    const auto by = [&](flow::Kind kind, double asked) {
      return impact::simulate(model, {.accuracy = asked, .max_time = max_time, .flow = kind});
    };
    const auto one = by(flow::Kind::taylor, accuracy), two = by(flow::Kind::cvode_adams, 0.1 * accuracy);
    BOOST_TEST((one.ending == two.ending), one.message << two.message);
    BOOST_TEST(one.events.size() == two.events.size());
    BOOST_TEST(difference(one.velocity, two.velocity) < accuracy);
    BOOST_TEST(std::abs(one.energy.residual) < accuracy);
    BOOST_TEST(steps(one, flow::Kind::cvode_adams) == 0);
    series += steps(one, flow::Kind::taylor);
    adams += steps(two, flow::Kind::cvode_adams);
  }
};

}  // namespace mariotte::test
