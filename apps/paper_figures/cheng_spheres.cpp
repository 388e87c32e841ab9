#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "body_reference.hpp"
#include "cheng.hpp"
#include "mariotte/impact/microbody/capture_velocity.hpp"
#include "strike.hpp"

namespace mariotte::paper_figures {
namespace {

constexpr double agreement = 1e-8;
struct Known {
  double diameter;          ///< [µm]
  double capture_velocity;  ///< in extended precision [m/s]
};
constexpr Known known[] = {{2.58, 2.44599766}, {3.44, 1.81857741}, {4.90, 1.31035940}, {6.89, 0.99740940}};
constexpr double slowest = 0.5, fastest = 30, growth = 1.02;  // speeds of the curves [m/s]

Strike sphere(double radius, double speed) {
  return {.shape = "sphere", .friction = 0, .speed = speed, .radius = radius};
}

/// e_n against speed; 0 where the sphere is captured.
Curve curve(double radius) {
  Curve curve{.name = fmt::format("{:.2f} µm", 2e6 * radius), .style = Style::line};
  for (double speed = slowest; speed < fastest; speed *= growth) {
    curve.x.push_back(speed);
    curve.y.push_back(simulate(sphere(radius, speed)).restitution.tip);
  }
  return curve;
}

double capture_velocity(double radius) {
  const auto found = impact::capture_velocity([&](double speed) { return microbody(sphere(radius, speed)); },
                                              2, 1e-9, {.accuracy = 1e-11});
  return found ? found->value() : NAN;
}

struct Agreement {
  double restitution = 0;  ///< largest difference
  double endings = 0;      ///< cases that end otherwise
};

Agreement compare(double radius) {
  Agreement found;
  for (const auto& one : sphere_references(radius)) {
    const auto impact = simulate(sphere(radius, -one["velocity"][0].get<double>()));
    found.endings += hybrid::name(impact.ending) != one["ending"].get<std::string>();
    if (one.contains("restitution"))
      found.restitution =
          std::max(found.restitution, std::abs(impact.restitution.tip - one["restitution"][0].get<double>()));
  }
  return found;
}

Reproduction make() {
  Reproduction result;
  result.picture = {.title = "spheres of ammonium fluorescein on silicon",
                    .x_label = "incident normal speed v_n [m/s]",
                    .y_label = "restitution e_n",
                    .commands = "set logscale x\nset xrange [0.5:30]\n",
                    .curves = {}};
  std::vector<double> capture;
  for (const auto& [diameter, expected] : known) {
    const double radius = 1e-6 * diameter / 2;
    result.picture.curves.push_back(curve(radius));
    const auto [restitution, endings] = compare(radius);
    capture.push_back(capture_velocity(radius));
    result.checks.push_back(
        {fmt::format("{} µm: largest difference of e_n", diameter), restitution, 0, agreement});
    result.checks.push_back({fmt::format("{} µm: other endings", diameter), endings, 0, 0});
    result.checks.push_back(
        {fmt::format("{} µm: capture velocity [m/s]", diameter), capture.back(), expected, 1e-7});
  }
  result.claims = {{"smaller spheres are captured at higher speeds",
                    yes_if(std::is_sorted(capture.rbegin(), capture.rend())),
                    fmt::format("up to {:.3f} m/s", fmt::join(capture, ", "))}};
  result.remark =
      "The experiment's points are not printed as numbers: agreement with it is not judged. Prefactors of "
      "the damping "
      "coefficients are a reconstruction.";
  return result;
}

}  // namespace

std::vector<Figure> cheng_spheres() {
  return {{"cheng-7", "Cheng, Brach & Dunn 2002, figure 7: restitution of spheres", make}};
}

}  // namespace mariotte::paper_figures
