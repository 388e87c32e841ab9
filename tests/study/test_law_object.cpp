// A law that is an object is swept and reported as any other.
#define BOOST_TEST_MODULE sweeps and reports of a law that is an object
#include <boost/test/unit_test.hpp>

#include "mariotte/contact/named_laws.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/table/table.hpp"
#include "mariotte/study/sweep/batch.hpp"
#include "mariotte/study/sweep/sweep_reader.hpp"
#include "mariotte/study/sweep/variation.hpp"

using namespace mariotte;

namespace {

const std::string text = R"([chain]
mass = [1, 1, 1]
velocity = [1, 0, 0]
law = ["hunt-crossley", "hertz"]
stiffness = 1
damping = [0.2, 0]
[[sweep]]
key = "chain.damping[0]"
from = 0.2
to = 0.6
count = 401
)";

study::SweepPlan plan() {
  return study::read_sweep(scene::parse_document(text, "s.toml"));
}

impact::ChainImpact impact_of(const scene::Scene& scene) {
  return impact::simulate(std::get<model::Chain>(scene.model), scene.run);
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_point_of_a_sweep_has_its_own_damping) {
  const auto one = plan();
  const auto slots = study::find_slots(one.document, one.design);
  BOOST_TEST(!slots.has_value());  // objects show no numbers that could be set
  study::Variation variation(one.document, one.design, slots);
  double last = 1;
  for (const Index point : {0, 200, 400}) {
    const auto& scene = variation.at(point);
    BOOST_TEST(contact::parameters(std::get<model::Chain>(scene.model).law[0])[1].value ==
                   0.2 + 0.001 * static_cast<double>(point),
               boost::test_tools::tolerance(1e-15));
    std::vector<double> numbers(1);
    study::make_evaluate({{"final.velocity[2]"}})(scene, numbers);
    BOOST_TEST(std::abs(numbers[0] - impact_of(scene).velocity[2]) < 1e-9);
    BOOST_TEST(numbers[0] < last);  // more is lost
    last = numbers[0];
  }
}

BOOST_AUTO_TEST_CASE(results_name_the_law_and_its_numbers) {
  const auto scene = study::Variation(plan().document, plan().design, {}).at(0);
  const auto contact = report::json(scene)["chain"]["contact"][0];
  BOOST_TEST(contact["law"] == "hunt-crossley");
  BOOST_TEST(contact["stiffness"] == 1);
  BOOST_TEST(contact["damping"] == 0.2);
  BOOST_TEST(contact["exponent"] == 1.5);
  const auto table = report::table(scene);
  BOOST_TEST(table.find("exponent n  gap [m]  other numbers [SI]\n") != std::string::npos, table);
  BOOST_TEST(table.find("1.5        0         damping 0.2\n") != std::string::npos, table);
  BOOST_TEST(report::table(impact_of(scene), scene, report::Detail::full).find("taylor") !=
             std::string::npos);
}
