#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "acary.hpp"
#include "chain_reference.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"

namespace mariotte::paper_figures {
namespace {

constexpr double accuracy = 1e-12;
constexpr double agreement = 1e-9;
constexpr double small = 0.01, big = 0.05;  // radii [m]
constexpr std::size_t balls = 21;           // of the chains of figure 2(b)
constexpr std::size_t big_ball = 10;        // counted from 1
constexpr contact::Elasticity steel = {.young = 210e9, .poisson = 0.3};
constexpr double density = 7800;

/// Touching steel balls of these radii [m]; the first strikes the others at 1 m/s.
model::Chain steel_chain(const std::vector<double>& radius) {
  model::Chain chain;
  for (const double r : radius) chain.mass.push_back(4.0 / 3.0 * std::numbers::pi * density * r * r * r);
  for (std::size_t j = 0; j + 1 < radius.size(); ++j)
    chain.law.push_back(contact::Hertz{contact::hertz_stiffness(steel, radius[j], steel, radius[j + 1])});
  chain.gap.assign(radius.size() - 1, 0.0);
  chain.velocity.assign(radius.size(), 0.0);
  chain.velocity[0] = 1;
  return chain;
}

std::vector<double> ratios(const std::vector<double>& radius) {
  std::vector<double> list;
  for (const auto& ratio : impact::simulate(steel_chain(radius), {.accuracy = accuracy}).icr)
    list.push_back(ratio.value_or(NAN));
  return list;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double most = a.size() == b.size() ? 0 : NAN;
  for (std::size_t i = 0; i < a.size() && i < b.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

/// Every ratio of a chain against its reference, in one number.
Check all_ratios(const std::string& chain, const std::vector<double>& found, const nlohmann::json& truth) {
  return {chain + ": largest difference of any α", largest_difference(found, truth["icr"]), 0, agreement};
}

std::vector<double> counting(std::size_t count) {
  std::vector<double> numbers;
  for (std::size_t i = 1; i <= count; ++i) numbers.push_back(static_cast<double>(i));
  return numbers;
}

Reproduction number_of_balls() {
  Curve others{"other triplets", Style::points, {}, {}}, last{"last triplet", Style::line_and_points, {}, {}};
  Reproduction result;
  double nearest = INFINITY, widest = 0;
  for (std::size_t n = 3; n <= balls; ++n) {
    const auto found = ratios(std::vector<double>(n, small));
    for (std::size_t i = 0; i < found.size(); ++i) {
      auto& curve = i + 1 == found.size() ? last : others;
      curve.x.push_back(static_cast<double>(n));
      curve.y.push_back(found[i]);
    }
    result.checks.push_back(all_ratios(fmt::format("{} balls", n), found, equal_chain_reference(n)));
    if (n < 5) continue;
    const auto [least, most] = std::minmax_element(found.begin(), found.end() - 1);
    nearest = std::min(nearest, found.back() - *most);
    widest = std::max(widest, *most - *least);
  }
  result.picture = {.title = "impulse correlation ratios of n equal steel balls",
                    .x_label = "number of balls n",
                    .y_label = "α_i = p_i / p_{i+1}",
                    .commands = "set xrange [2.5:21.5]\n",
                    .curves = {others, last}};
  result.claims = {
      {"the ratio of the last triplet is very different from the others",
       nearest > widest ? Verdict::yes : Verdict::partly,
       fmt::format("from 5 balls on it lies at least {:.3f} above the others, which differ by at "
                   "most {:.3f}",
                   nearest, widest)}};
  return result;
}

Reproduction big_ball_in_the_middle() {
  std::vector<double> radius(balls, small);
  const auto equal = ratios(radius);
  radius[big_ball - 1] = big;
  const auto unequal = ratios(radius);
  const double triplet = ratios({small, big, small}).at(0);
  const auto truth = big_ball_reference("21-big10");
  Reproduction result;
  result.picture = {
      .title = "21 steel balls of 10 mm, and with a tenth of 50 mm",
      .x_label = "triplet i",
      .y_label = "α_i = p_i / p_{i+1}",
      .commands = "set xrange [0.5:19.5]\n",
      .curves = {{"equal balls", Style::line_and_points, counting(equal.size()), equal},
                 {"big tenth ball", Style::line_and_points, counting(unequal.size()), unequal}}};
  result.checks = {all_ratios("equal balls", equal, equal_chain_reference(balls)),
                   all_ratios("big tenth ball", unequal, truth),
                   {"α_9, at the big ball", unequal[8], truth["icr"][8], agreement},
                   {"α_19, the last triplet", unequal[18], truth["icr"][18], agreement},
                   {"α of the triplet 10-50-10", triplet, big_ball_reference("10-50-10")["icr"][0], 1e-8}};
  const double behind = std::abs(unequal[18] - equal[18]);
  result.claims = {
      {"the ratio at the big ball is different", yes_if(std::abs(unequal[8] - equal[8]) > 0.1),
       fmt::format("α_9 = {:.4f} instead of {:.4f}", unequal[8], equal[8])},
      {"so are those of triplets 10 to 19", behind > 0.1 ? Verdict::yes : Verdict::partly,
       fmt::format("α_10 = {:.4f} instead of {:.4f}, α_19 = {:.4f} instead of {:.4f}", unequal[9], equal[9],
                   unequal[18], equal[18])},
      {"three balls with a big middle one have α of about 63.47",
       std::abs(triplet - 63.47) < 0.005 ? Verdict::yes : Verdict::partly,
       fmt::format("{:.10f}; the digits printed fit a loose tolerance of the integrator", triplet)},
      {"which is very different from the value in the whole chain", yes_if(triplet > 2 * unequal[8]),
       fmt::format("{:.2f} and {:.2f}", triplet, unequal[8])}};
  result.remark =
      "The paper prints E = 210 MPa; steel has 210 GPa. Without damping ratios do not depend on it.";
  return result;
}

}  // namespace

std::vector<Figure> acary_ratios() {
  return {{"acary-2a", "Acary & Brogliato 2003, figure 2(a): ratios against the number of balls",
           number_of_balls},
          {"acary-2b", "Acary & Brogliato 2003, figure 2(b): a big ball in a chain of 21",
           big_ball_in_the_middle}};
}

}  // namespace mariotte::paper_figures
