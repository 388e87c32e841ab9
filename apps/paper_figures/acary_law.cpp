#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "acary.hpp"
#include "mariotte/impact/laws/multiple_impact_law.hpp"
#include "triplet.hpp"

namespace mariotte::paper_figures {
namespace {

constexpr double accuracy = 1e-12;
constexpr double agreement = 1e-13;
constexpr int intervals = 50;

const std::vector<double> incident = {1, 0, 0};

impact::LawOutcome law(double ratio) {
  return impact::multiple_impact(impact::chain_configuration({1, 1, 1}, incident),
                                 {.direction = impact::direction_of_ratios({ratio})});
}

/// [Acary 2003, eq. 14–16] for e = 1, where Δ = 1; there α is p₂/p₁.
std::vector<double> closed_form(double ratio) {
  const double t = 1 / ratio, first = 1 / (1 - t + t * t);
  return {first, t * first};
}

std::vector<Check> checks() {
  std::vector<Check> list;
  const auto compare = [&](double ratio, const std::vector<double>& velocity) {
    const auto outcome = law(ratio);
    for (std::size_t i = 0; i < 3; ++i)
      list.push_back(
          {fmt::format("v{} at α = {}", i + 1, ratio), outcome.velocity[i], velocity[i], agreement});
  };
  compare(1, {0, 0, 1});
  compare(2, {-1.0 / 3, 2.0 / 3, 2.0 / 3});
  for (const double ratio : {1.2, 1.5, 1.8}) {
    const auto p = closed_form(ratio);
    compare(ratio, {1 - p[0], p[0] - p[1], p[1]});
  }
  return list;
}

/// Triplets whose third ball rests.
struct Simulated {
  std::vector<double> ratio;
  std::vector<std::vector<double>> velocity, impulse;
};

const Simulated& simulated() {
  static const auto all = [] {
    Simulated list;
    for (const char* law : {"hertz", "linear"})
      for (const double stiffness : {0.01, 0.1, 0.5, 1.0, 2.0, 10.0, 100.0}) {
        const auto impact = impact::simulate(chain({law, stiffness, 0}), {.accuracy = accuracy});
        list.ratio.push_back(impact.icr[0].value());
        list.velocity.push_back(impact.velocity);
        list.impulse.push_back({impact.contacts[0].impulse, impact.contacts[1].impulse});
      }
    return list;
  }();
  return all;
}

/// Simulated velocities lie on the curves of the law.
Check on_the_curves(const Simulated& points) {
  double most = 0;
  for (std::size_t k = 0; k < points.ratio.size(); ++k) {
    const auto outcome = law(points.ratio[k]);
    for (std::size_t i = 0; i < 3; ++i)
      most = std::max(most, std::abs(outcome.velocity[i] - points.velocity[k][i]));
  }
  return {"largest distance of simulated velocities from the law", most, 0, 100 * accuracy};
}

Claim bounds(const Simulated& points) {
  const auto [least, most] = std::minmax_element(points.ratio.begin(), points.ratio.end());
  return {
      "ratios of compliant chains keep the bounds of the law", yes_if(*least >= 1 && *most <= 2),
      fmt::format("1 ≤ α ≤ 2; simulated with stiffness ratios 0.01 … 100: {:.4f} … {:.4f}", *least, *most)};
}

std::vector<double> column(const std::vector<std::vector<double>>& rows, std::size_t i) {
  std::vector<double> values;
  for (const auto& row : rows) values.push_back(row[i]);
  return values;
}

/// `names` of the curves that `of` takes from an outcome, and the same of simulations as points.
template <class Of>
Reproduction figure(const std::string& quantity, const std::string& letter, const Of& of,
                    const std::vector<std::vector<double>>& points) {
  Reproduction result;
  const auto& simulations = simulated();
  const std::size_t curves = points.front().size();
  for (std::size_t i = 0; i < curves; ++i) {
    Curve curve{fmt::format("{}_{}", letter, i + 1), Style::line, {}, {}};
    for (int k = 0; k <= intervals; ++k) {
      curve.x.push_back(1 + static_cast<double>(k) / intervals);
      curve.y.push_back(of(law(curve.x.back()))[i]);
    }
    result.picture.curves.push_back(std::move(curve));
  }
  for (std::size_t i = 0; i < curves; ++i)
    result.picture.curves.push_back(
        {fmt::format("{}_{} simulated", letter, i + 1), Style::points, simulations.ratio, column(points, i)});
  result.picture.title = quantity + " by the multiple-impact law, e = 1";
  result.picture.x_label = "α = p_1 / p_2";
  result.picture.y_label = quantity + (letter == "v" ? " v^+ / v_1^-" : " p / mv_1^-");
  result.checks = checks();
  result.checks.push_back(on_the_curves(simulated()));
  result.claims = {
      {"v⁺ = (0, 0, 1) and (−1/3, 2/3, 2/3) are found for extremal values of α",
       yes_if(std::all_of(result.checks.begin(), result.checks.end(), holds)), "at α = 1 and α = 2"},
      bounds(simulations)};
  result.remark = "The appendix of the paper takes α = p₂/p₁; here it is p₁/p₂ as in its equation 5.";
  return result;
}

Reproduction velocities() {
  return figure(
      "velocity after", "v", [](const impact::LawOutcome& o) { return o.velocity; }, simulated().velocity);
}

Reproduction impulses() {
  return figure(
      "impulse", "p", [](const impact::LawOutcome& o) { return o.impulse; }, simulated().impulse);
}

}  // namespace

std::vector<Figure> acary_law() {
  return {{"acary-3a", "Acary & Brogliato 2003, figure 3(a): velocities against α", velocities},
          {"acary-3b", "Acary & Brogliato 2003, figure 3(b): impulses against α", impulses}};
}

}  // namespace mariotte::paper_figures
