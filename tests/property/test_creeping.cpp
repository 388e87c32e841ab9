#define BOOST_TEST_MODULE creeping contacts
#include <boost/test/unit_test.hpp>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/reference.hpp"

using namespace mariotte;

namespace {

contact::Law law(double stiffness, double damping, double exponent) {
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = exponent};
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_slack_contact_pushes_again_though_its_load_never_crosses_zero) {
  const auto law = [](double damping, double exponent) -> contact::Law {
    return contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = exponent};
  };
  const double c = 170416.57844109138;
  const model::Chain chain{.mass = {1.0738029564724281, 1.3563863675731072, 1.0303502892178085,
                                    1.1098930480392786, 0.93088922732940782},
                           .law = {law(c, 2.6110034181761002), law(c, 1.2225513484005912), law(c, 2),
                                   law(43375.952006798463, 1.5936054153381563)},
                           .gap = {0, 0, 0, 0.95960795681985478},
                           .velocity = {-0.017303536692897525, 0.92968049354896998, 0.53347408962003251,
                                        0.36750739284562739, -0.51590601840248596}};
  const std::vector<double> expected = {-0.0173035366929, 0.3926157361126, 0.3926157363933, 0.3926157551822,
                                        0.3926157893939};
  impact::ChainSolver solver;
  for (const char* flow : {"auto", "pair", "cvode-bdf-klu"})
    for (const double accuracy : {1e-8, 1e-10}) {
      const auto& impact = solver.solve(chain, {.accuracy = accuracy, .flow = flow::parse_kind(flow)});
      BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
      BOOST_TEST(test::difference(impact.velocity, expected) < 1e-8);
    }
}

BOOST_AUTO_TEST_CASE(a_creeping_contact_that_is_slack_pushes_when_its_ball_is_struck) {
  const model::Chain chain{
      .mass = {0.86109508052885531, 0.019626733410813724, 1.2029642451828209, 0.002866735570710187,
               1.0743345974517902},
      .law = {law(0.84085105301427454, 1.0396010901287691, 1.3480994199454446),
              law(0.48307531807549953, 516215.73794586828, 2.5475882803302552),
              law(2.5479691955213943, 124330.04496370252, 1), law(2.3361399329594486, 10.796864350409264, 3)},
      .gap = {0.26860743640274803, 0.27336320705633449, 0, 0.17994015993640594},
      .velocity = {0.3340083038917494, 0.057007858063889749, 0.031172440212457131, -0.49499560266224307,
                   -0.75149076687757765}};
  const std::vector<double> expected = {-0.3138243532461, -0.1272383025038, -0.1272382963413,
                                        -0.1272382962174, -0.0524814868083};
  impact::ChainSolver solver;
  for (const char* flow : {"auto", "pair", "taylor", "cvode-bdf-dense", "cvode-bdf-klu"}) {
    const auto& impact = solver.solve(chain, {.accuracy = 1e-10, .flow = flow::parse_kind(flow)});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(test::difference(impact.velocity, expected) < 1e-10, flow);
  }
}

BOOST_AUTO_TEST_CASE(creeping_contacts_that_are_pressed_gently_close_once) {
  const auto law = [](double damping) -> contact::Law {
    return contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = 1.5};
  };
  const double a = 0.032793122376252815, b = 0.012138095429851203, c = 24082.68478746539,
               d = 0.016492458150956645;
  const model::Chain chain{
      .mass = {2.8586548915218448, 0.39326800929293015, 2.6221666991128667, 0.90656716091553291,
               0.25335214723695609, 0.90656716091553291, 2.6221666991128667, 0.39326800929293015,
               2.8586548915218448},
      .law = {law(a), law(b), law(c), law(d), law(d), law(c), law(b), law(a)},
      .gap = {0.77324338771667933, 0, 0, 0, 0, 0, 0, 0.77324338771667933},
      .velocity = {0.69670189141967853, -0.018566719527258524, -0.48471294706181967, 0.72599688177859711, 0,
                   -0.72599688177859711, 0.48471294706181967, 0.018566719527258524, -0.69670189141967853}};
  const std::vector<double> expected = {
      -0.52662011324782, -0.40031747067613, -0.38945090863599, -0.38945076126526, 0,
      0.38945076126526,  0.38945090863599,  0.40031747067613,  0.52662011324782};
  impact::ChainSolver solver;
  for (const double accuracy : {1e-8, 1e-10, 1e-12}) {
    const auto& impact = solver.solve(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(test::difference(impact.velocity, expected) < 10 * accuracy);
    BOOST_TEST(impact.events < 100);
  }
  const auto& exact = solver.solve(chain, {.accuracy = 1e-10, .flow = flow::Kind::cvode_bdf_klu});
  BOOST_TEST(test::difference(exact.velocity, expected) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_load_that_has_vanished_but_for_rounding_lets_go) {
  const auto law = [](double damping) -> contact::Law {
    return contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = 1};
  };
  const double c = 242590.50532552626;
  const model::Chain chain{
      .mass = {infinity, 1, 1, 1, 1, 1, 1},
      .law = {law(c), law(c), law(0), law(0), law(19.848551714223479), law(1.0278364182577986)},
      .gap = {0, 0.59122601523115459, 0, 0, 0, 0.10462388190869765},
      .velocity = {-0.1143960121276224, -0.90667599512389252, -0.10111748384791364, 0.48582769072459131,
                   0.67121107609516595, 0.019312801264995905, -0.74371879335273672}};
  const auto impact = impact::ChainSolver().solve(chain, {.accuracy = 1e-10});
  BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
  BOOST_TEST(test::difference(impact.velocity,
                              impact::ChainSolver()
                                  .solve(chain, {.accuracy = 1e-10, .flow = flow::Kind::cvode_bdf_klu})
                                  .velocity) < 1e-9);
}

BOOST_AUTO_TEST_CASE(a_pair_that_creeps_below_the_accuracy_does_not_flicker) {
  const model::Chain chain{.mass = {0.010028050590716606, 3.7036621716818301, 2.5058198105651686,
                                    1407.1881625262527, 20.557140488961473},
                           .law = {law(3.9061713182041786, 13.041806592040961, 1),
                                   law(0.44442621882445754, 0.0013487739669325093, 2.6724775552478306),
                                   law(1.7376951588404836, 0.014079893276983229, 2.1098881169464438),
                                   law(0.76731103327487482, 39.271270226512407, 2.9013998113167645)},
                           .gap = {0, 0, 0, 0},
                           .velocity = {-0.37680769333700059, -0.37680778857095332, -0.047488539081299352,
                                        -0.047495892493937715, -0.047450274154349797}};
  const std::vector<double> expected = {-0.37680778833552, -0.37680778831373, -0.04750321903155,
                                        -0.04749586635293, -0.04745027415435};
  impact::ChainSolver solver;
  for (const double accuracy : {1e-6, 1e-8, 1e-10}) {
    const auto& impact = solver.solve(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(test::difference(impact.velocity, expected) < accuracy);
    BOOST_TEST(impact.events < 500);
  }
}

BOOST_AUTO_TEST_CASE(a_slack_contact_with_a_load_of_rounding_is_not_passed_through) {
  const contact::Law damped =
      contact::Viscoelastic{.stiffness = 1.0778871004500228, .damping = 632104.1441450878, .exponent = 1};
  const contact::Law hertz = contact::Hertz(0.92789365029987081);
  const model::Chain chain{
      .mass = {infinity, 1.7189054831506989, 0.78615945336288851, 0.52839354596528931, infinity},
      .law = {damped, damped, hertz, hertz},
      .gap = {0.24948759460955106, 0.55493070342845696, 0.42234942747488147, 0.40084704338239796},
      .velocity = {0, -0.19261448545608562, -0.76179604768618892, -0.73746643368135256, 0}};
  const std::vector<double> expected = {0, -8.2895364e-07, -1.6579084e-06, -0.0430323142, 0};
  impact::ChainSolver solver;
  for (const char* flow : {"auto", "modal", "cvode-bdf-klu"})
    for (const double accuracy : {1e-8, 1e-10}) {
      const auto& impact = solver.solve(
          chain, {.accuracy = accuracy, .max_time = 2.9853709783626998, .flow = flow::parse_kind(flow)});
      BOOST_TEST((impact.ending == hybrid::Ending::time_limit), impact.message);
      BOOST_TEST(test::difference(impact.velocity, expected) < 1e-9, flow);
    }
}

BOOST_AUTO_TEST_CASE(what_creeps_lets_go_once_at_every_accuracy_by_every_flow) {
  struct {
    model::Chain chain;
    std::vector<double> expected;
  } const scenes[] = {
      {{.mass = {1.1040862051333844, 0.01232210769577253, 1.2836528822141628, 0.016097350439654337,
                 0.73371441418892103, 0.0012054550306491928},
        .law = {law(0.39787461188929285, 1.041500553151486, 1.7164802129404855),
                law(0.93728731708293123, 0.1804180334450714, 2.4745020266467721),
                law(0.53296283085138063, 0, 1.110210393136561),
                law(1.3480194758664077, 1953.6193180817702, 1),
                law(1.167786666263495, 11.057973970246787, 1.7026603159364864)},
        .gap = {0, 0.37255218069257273, 0.22371646221897545, 0.35464081508214362, 0.33679885417617972},
        .velocity = {0.51488247128385178, -0.18666009180500565, -0.19483903698884419, -0.67737373186853489,
                     -0.73154616729889699, -0.79277222792898416}},
       {-0.470493354725, -0.2967195568933, -0.02107274253276, 0.4229382398402, 0.4229385391154,
        0.4235641298726}},
      {{.mass = {1, 1, 1, 1, 1, 1, 1},
        .law = {law(1, 8273.9677894580182, 2), law(1, 0, 2.8967103476191287), law(1, 0, 1.308822742463001),
                law(1, 5251.6249944293731, 1), law(1, 5251.6249944293731, 2.484236378386004), law(1, 0, 1)},
        .gap = {0, 0, 0, 0.39470525410333246, 0, 0},
        .velocity = {-0.055190800857205291, 0.82279264604125535, 0.93211234366088114, -0.41051317435595602,
                     -0.93743185622609149, -0.87241716247989221, 0.1601997205122272}},
       {-0.74471624801, -0.7447146876936, -0.4565848739119, 0.3183444969202, 0.3183446025046, 0.31835530055,
        0.6305231259365}}};
  impact::ChainSolver solver;
  for (const auto& [chain, expected] : scenes)
    for (const char* flow : {"auto", "modal", "cvode-bdf-klu"})
      for (const double accuracy : {1e-8, 1e-10, 1e-12}) {
        const auto& impact = solver.solve(chain, {.accuracy = accuracy, .flow = flow::parse_kind(flow)});
        BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
        BOOST_TEST(test::difference(impact.velocity, expected) < 1e-11, flow << " at " << accuracy);
      }
}

BOOST_AUTO_TEST_CASE(a_damper_in_a_network_is_not_followed_while_it_creeps) {
  const auto network = model::as_network({.mass = {0.55175073646940376, 248.97902720314315},
                                          .law = {law(0.60009930460237426, 13396.870212254129, 1.5)},
                                          .gap = {0},
                                          .velocity = {-0.20762493089325096, -0.62680731628081054}});
  for (const double accuracy : {1e-6, 1e-10, 1e-12}) {
    const auto impact = impact::simulate(network, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(impact.time < 0.06);
    BOOST_TEST(test::difference(impact.velocity, std::vector{-0.6258804789416, -0.6258804397914}) < 1e-12);
  }
}

// Each contact draws its neighbours once the fast decay is over: all let go then, one after the other within
// 0.07 ms. Where the load of a neighbour is rounding, it holds nothing. Velocities by 60 digits.
BOOST_AUTO_TEST_CASE(what_creeps_side_by_side_lets_go_at_once_at_every_accuracy) {
  const double k = 7.3088424494698916e-05;
  const model::Chain chain{.mass = {2.0254983334546582e-06, 3.6062512118653719e-06, 1.8266078762539462e-06,
                                    3.368806667767394e-06, 1.5224823963381306e-06},
                           .law = {law(k, 0.045117604334535918, 1), law(k, 0.12599990371598219, 1),
                                   law(k, 0.17335039030831983, 1), law(k, 0.59720950309100806, 1)},
                           .gap = {0, 0, 0, 0},
                           .velocity = {0.22458674126093839, 0.15356154325499596, 0.036174816915156019,
                                        0.094174130200612341, 0.084782366916730675}};
  const std::vector<double> expected = {0.12316893362074214, 0.12316894099641129, 0.12316894244669406,
                                        0.12316894282641051, 0.12316894283838692};
  impact::ChainSolver solver;
  for (const char* flow : {"auto", "cvode-bdf-klu"})
    for (const double accuracy : {1e-6, 1e-8, 1e-10, 1e-12}) {
      const auto& impact = solver.solve(chain, {.accuracy = accuracy, .flow = flow::parse_kind(flow)});
      BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
      BOOST_TEST(impact.time < 0.002);
      BOOST_TEST(test::difference(impact.velocity, expected) < 1e-14, flow << " at " << accuracy);
    }
}

// The weight of four balls is a ten-thousandth of what rounding makes of a load; each contact holds the next.
BOOST_AUTO_TEST_CASE(balls_that_sink_by_a_weight_below_rounding_stay_in_contact) {
  const double c = 1e8;
  const model::Chain chain{.mass = {infinity, 1, 1, 1, 1},
                           .law = std::vector(4, law(1, c, 1)),
                           .gap = {0, 0, 0, 0},
                           .velocity = {0, -1, -1, -1, -1},
                           .gravity = 1e-10};
  const auto impact = impact::ChainSolver().solve(chain, {.accuracy = 1e-10, .max_time = 1e4});
  BOOST_TEST(impact.events == 1);
  BOOST_TEST(impact.periods == (std::vector<Index>{1, 1, 1, 1}), boost::test_tools::per_element());
}
