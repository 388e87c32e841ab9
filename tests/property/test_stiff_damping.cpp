#define BOOST_TEST_MODULE stiff damping
#include <boost/test/unit_test.hpp>
#include <random>

#include "mariotte/core/error.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "support/reference.hpp"

using namespace mariotte;

namespace {

contact::Law law(double stiffness, double damping, double exponent) {
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = exponent};
}

/// Balls and Hertz-like dampers of c = 10 to 10^`most`; many contacts creep, pressed by their neighbours.
model::Chain random_chain(std::mt19937_64& random, double most) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto decades = [&](double low, double high) {
    return std::pow(10, low + (high - low) * unit(random));
  };
  model::Chain chain;
  const int balls = std::uniform_int_distribution(2, 4)(random);
  for (int i = 0; i < balls; ++i) {
    chain.mass.push_back(decades(-1, 1));
    chain.velocity.push_back(i == 0 ? 1 : -unit(random) * (unit(random) < 0.5));
  }
  for (int j = 0; j + 1 < balls; ++j) {
    chain.gap.push_back(unit(random) < 0.7 ? 0 : 0.01 * unit(random));
    chain.law.push_back(
        contact::Viscoelastic{.stiffness = decades(-1, 1), .damping = decades(1, most), .exponent = 1.5});
  }
  return chain;
}

/// Compares random chains of c = 10 to 10^`most_damping` with BDF; returns the most steps of one. Up to c =
/// 10⁴ BDF knows loads so well that numbers of periods are the same; beyond, it has ghosts.
Index check_creeping(unsigned seed, int scenes, double most_damping) {
  std::mt19937_64 random(seed);
  impact::ChainSolver solver;
  Index most_steps = 0;
  for (int i = 0; i < scenes; ++i) {
    const auto chain = random_chain(random, most_damping);
    const auto own = solver.solve(chain, {.accuracy = 1e-8});
    const auto exact = solver.solve(chain, {.accuracy = 1e-11, .flow = flow::Kind::cvode_bdf_klu});
    BOOST_TEST_CONTEXT("scene " << i) {
      BOOST_TEST((own.ending == hybrid::Ending::separated));
      BOOST_TEST(test::difference(own.velocity, exact.velocity) < 1e-8);
      if (most_damping <= 4) BOOST_TEST(own.periods == exact.periods, boost::test_tools::per_element());
    }
    most_steps = std::max(most_steps, own.steps);
  }
  return most_steps;
}

}  // namespace

// The load of a creeping contact is a small difference of large terms: told with too few digits its sign
// makes ghost periods, and explicit steps would last for ever.
BOOST_AUTO_TEST_CASE(creeping_contacts_make_no_ghost_events_and_come_to_an_end) {
  BOOST_TEST(check_creeping(7, 80, 4) < 50'000);
}

// There the load is rounding from the start; where nothing creeps for long BDF takes 700 times as long.
BOOST_AUTO_TEST_CASE(series_follow_dampers_however_strong) {
  BOOST_TEST(check_creeping(8, 40, 8) < 50'000);
  const model::Chain triplet{
      .mass = {1, 1, 1}, .law = {law(1, 1e6, 1.5), law(1, 1e6, 1.5)}, .gap = {0, 0}, .velocity = {1, 0, 0}};
  BOOST_TEST(impact::ChainSolver().solve(triplet).steps < 200);
}

// A load that has vanished but for rounding when its contact becomes slack may stand above zero already.
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

// A contact creeps apart by itself, its load but rounding, when the ball behind it is struck: gently at
// first.
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

// Two slow balls between fast ones: what is rounding of the fast ones is none of theirs.
BOOST_AUTO_TEST_CASE(slow_balls_among_fast_ones_close_and_open_a_few_times) {
  const std::vector<contact::Law> half = {
      contact::Viscoelastic{
          .stiffness = 404.26751224197528, .damping = 0.051762067112120475, .exponent = 1.6484198088926214},
      contact::Viscoelastic{.stiffness = 4.7446296344718881, .damping = 0, .exponent = 2},
      contact::Viscoelastic{
          .stiffness = 1.5324059912037331e-05, .damping = 2.4677633278642192e-08, .exponent = 3},
      contact::Viscoelastic{.stiffness = 0.00060654201433523456,
                            .damping = 0.043443157714494897,
                            .exponent = 2.7090626569376974}};
  model::Chain chain{
      .mass = {34.018686418929484, 6.1220185821179394, 12.233869746456932, 11.400613920154244,
               705.18962325216592, 11.400613920154244, 12.233869746456932, 6.1220185821179394,
               34.018686418929484},
      .law = half,
      .gap = {0, 210668.6645034141, 196417.42754450851, 294168.9939699081, 294168.9939699081,
              196417.42754450851, 210668.6645034141, 0},
      .velocity = {23462941.317596033, 14515987.323729215, -18007288.059202071, 22445550.75360848, 0,
                   -22445550.75360848, 18007288.059202071, -14515987.323729215, -23462941.317596033}};
  chain.law.insert(chain.law.end(), half.rbegin(), half.rend());
  impact::ChainSolver solver;
  for (const double accuracy : {1e-8, 1e-10, 1e-12}) {
    const auto& impact = solver.solve(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(impact.events < 100);
  }
}

// Contacts that creep are pressed gently: at first their loads are smaller than rounding makes them.
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

// The closed form of a pair starts with a load that rounding has made negative.
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

BOOST_AUTO_TEST_CASE(damping_beyond_double_precision_is_refused) {
  for (const double damping : {1e14, 1e50, 1e100, 1e280})
    for (const double exponent : {1.0, 1.5}) {
      const contact::Law law =
          contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = exponent};
      const model::Chain chain{.mass = {1, 1, 1}, .law = {law, law}, .gap = {0, 0}, .velocity = {1, 0, 0}};
      BOOST_CHECK_THROW(impact::ChainSolver().solve(chain), InvalidParameter);
    }
}

BOOST_AUTO_TEST_CASE(the_strongest_damping_that_is_computed_stops_balls_together) {
  for (const double damping : {1e6, 1e8, 1e10, 5e11}) {
    const contact::Law law = contact::Viscoelastic{.stiffness = 1, .damping = damping, .exponent = 1};
    const model::Chain chain{.mass = {1, 1, 1}, .law = {law, law}, .gap = {0, 0}, .velocity = {1, 0, 0}};
    const auto impact = impact::ChainSolver().solve(chain);
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(test::difference(impact.velocity, {1.0 / 3, 1.0 / 3, 1.0 / 3}) < 1e-9);
  }
}

// All that the first pair does is below the accuracy: it lets go well above where it would close again.
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

// A ball of 0.01 rattles 3500 times between heavy ones while a damper creeps. BDF would take a hundred steps
// each time, series three: they go on.
BOOST_AUTO_TEST_CASE(what_rattles_beside_a_creeping_damper_stays_with_series) {
  const model::Chain chain{.mass = {24812.641456324927, 0.010463545199853212, 1448.5690932301716,
                                    57.711662327016668, 70.302378542774548},
                           .law = {law(0.00010700576034470817, 2.4272059348559763e-06, 1.1174548642958955),
                                   law(0.086776375135265524, 0, 1.3297293458487336),
                                   law(0.00017609856877118338, 0.0022763204154275809, 1.7606216572168762),
                                   law(2.8717213007202269, 0.46462178516388403, 3)},
                           .gap = {0.21205815546305007, 0, 3.3854757569142216e-08, 3.8377334248590293e-06},
                           .velocity = {1, 0, 0, 0, 0}};
  const std::vector<double> expected = {0.8805159855166, 1.8723509669694, 1.8786626459632, 1.9005432199910,
                                        1.9009067457253};
  for (const double accuracy : {1e-6, 1e-9}) {
    const auto impact = impact::ChainSolver().solve(chain, {.accuracy = accuracy});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(test::difference(impact.velocity, expected) < accuracy);
    BOOST_TEST(impact.steps < 60'000);
  }
}

// Contact 2 lets go with a load of rounding, above zero as well as below. What strikes its ball begins
// gently.
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

// A contact that creeps like exp(−k t/c) has a load smaller than its rounding. Whether it still pushes must
// not depend on whether that crosses zero.
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

// Its load vanishes within a twentieth of its natural time; it would creep for 10⁵ of them.
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

// Of a contact that has hardly begun, coefficients of order 20 are as large as (δ̇/δ)²⁰ with δ = 10⁻¹⁷.
BOOST_AUTO_TEST_CASE(series_of_a_contact_that_has_hardly_begun_do_not_overflow) {
  const model::Chain chain{
      .mass = {0.7761538174417637, 0.90334308846299383, 1.6130654382674201, 1.0653062242311309},
      .law = {law(1, 0.31137376435825925, 3), law(1, 856.17378097676612, 1.1229864242378411),
              law(1, 0.049225910881886187, 1.5944080574212465)},
      .gap = {0, 0, 0},
      .velocity = {0.76801022962017962, 0.24409180884597825, 0.32658001912564183, -0.75254404977730682},
      .gravity = -0.60848021854188694};
  impact::ChainSolver solver;
  for (const double accuracy : {1e-10, 1e-13, 1e-15}) {
    const auto& impact = solver.solve(chain, {.accuracy = accuracy, .max_events = 100});
    BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
    BOOST_TEST(impact.periods == (std::vector<Index>{1, 1, 1}), boost::test_tools::per_element());
  }
}

// The load by which the second ball holds the light one is smaller than what a loose step makes of it.
BOOST_AUTO_TEST_CASE(a_light_ball_that_is_pressed_gently_stays_where_it_is_at_loose_accuracy) {
  const model::Chain chain{.mass = {0.00037966677690409972, 16.637117187372333, 132.59030537892272},
                           .law = {law(12.975591817359314, 93.768260694455705, 1),
                                   law(1113.0219139862654, 1.7103913486935007, 1.5)},
                           .gap = {0, 0},
                           .velocity = {1, 0, 0}};
  impact::ChainSolver solver;
  const auto exact = solver.solve(chain, {.accuracy = 1e-10});
  const auto loose = solver.solve(chain, {.accuracy = 1e-6, .max_events = 100});
  BOOST_TEST((loose.ending == hybrid::Ending::separated), loose.message);
  BOOST_TEST(loose.periods[0] <= exact.periods[0]);
  BOOST_TEST(test::difference(loose.velocity, exact.velocity) < 1e-6);
}

// Two light balls with a strong damper between them swing on a heavy one. BDF's first steps are no longer
// than those of series, which would need more than ten million of them; its later ones are.
BOOST_AUTO_TEST_CASE(series_lose_patience_with_a_damper_that_swings) {
  const model::Chain chain{.mass = {1671.5133400401337, 1931.7199056826878, 0.0058671970811175244,
                                    0.0043374688689555626, 1934.9315210821615},
                           .law = {law(0.12595767632776911, 0, 1.2450208712448474),
                                   law(0.0010990372726720763, 0.0017268427067702453, 1.6858878094517205),
                                   law(1.301907658342075, 760.90032168294522, 1.3180390311303654),
                                   law(375.54281429107579, 0.053539772941115706, 1.4507332755405389)},
                           .gap = {0, 0, 0, 0.83143977943791547},
                           .velocity = {0.17375322969634488, 0.70501693444886171, 0.83082167575411581,
                                        -0.34190805197290408, 0.093203598533756038}};
  const std::vector<double> expected = {0.0927381923, 0.1682967853, 0.6970125789, 0.6988083862, 0.6990167604};
  const auto impact = impact::ChainSolver().solve(chain, {.accuracy = 1e-8});
  BOOST_TEST((impact.ending == hybrid::Ending::separated), impact.message);
  BOOST_TEST(test::difference(impact.velocity, expected) < 1e-9);
  BOOST_TEST(impact.steps < 1'000'000);
}

// One damper makes many phases too stiff for series. The first of them takes 5000 of their steps before BDF
// goes on; the others are left earlier.
BOOST_AUTO_TEST_CASE(a_run_learns_when_to_leave_a_phase_to_bdf) {
  model::Chain chain{.mass = {0.889, 0.877, 1.058, 0.729, 1.154, 0.924, 1.041, 1.35},
                     .law = {law(1, 0, 1), law(1, 0, 1), law(1, 3.2e5, 1), law(1, 0, 1), law(1, 0, 1),
                             law(1, 0, 1.5), law(1, 0.0123, 1)},
                     .gap = std::vector<double>(7),
                     .velocity = std::vector<double>(8)};
  chain.velocity[0] = 1;
  const auto impact = impact::simulate(chain, {.accuracy = 1e-8});
  const auto steps = [&](std::string_view name) {
    for (const auto& use : impact.flows)
      if (use.name == name) return use;
    return impact::FlowUse{};
  };
  const auto bdf = steps("cvode-bdf-klu");
  BOOST_TEST(bdf.phases >= 5);
  BOOST_TEST(steps("taylor").steps < 5000 + 11 * bdf.steps);
  BOOST_TEST(steps("taylor").steps < 0.8 * 5000 * static_cast<double>(bdf.phases));
}
