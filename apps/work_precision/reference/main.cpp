// Computes the references that work_precision needs and no paper gives, and checks itself:
//   work_precision_reference map                      data/map.csv
//   work_precision_reference viscoelastic             the last rows of data/impacts.csv
//   work_precision_reference check TRIPLETS VISCO     against tests/data/chain/triplets.json,
//   viscoelastic.json
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "triplet.hpp"

namespace {

using namespace mariotte::reference;
using Json = nlohmann::json;

constexpr int map_points = 64;

std::string velocities(const Outcome& outcome) {
  return digits(outcome.velocity[0]) + "," + digits(outcome.velocity[1]) + "," + digits(outcome.velocity[2]);
}

void map() {
  fmt::print(
      "# Final velocities of Hertz triplets (m = k1 = 1, touching, v = (1, 0, last velocity)) in quadruple "
      "precision, by extrapolation in regularised variables: work_precision_reference map.\n"
      "stiffness ratio,last velocity,end,periods 1,periods 2,final velocities\n");
  for (int i = 0; i < map_points; ++i)
    for (int j = 0; j < map_points; ++j) {
      const double ratio = std::pow(10, -1 + 2.0 * i / (map_points - 1));
      const double last = -1 + static_cast<double>(j) / (map_points - 1);
      const auto outcome = impact({.stiffness = {1, ratio}, .damping = 0, .velocity = {1, 0, last}});
      fmt::print("{:.17g},{:.17g},{},{},{},{}\n", ratio, last, digits(outcome.end), outcome.periods[0],
                 outcome.periods[1], velocities(outcome));
    }
}

void viscoelastic() {
  for (const double damping : {0.1, 10.0, 100.0}) {
    const auto outcome = impact({.stiffness = {1, 1}, .damping = damping, .velocity = {1, 0, 0}});
    fmt::print("V-{:g},viscoelastic,1,{:g},0,{},{}\n", damping, damping, digits(outcome.end),
               velocities(outcome));
    fmt::print(stderr, "V-{:g} periods {} {}\n", damping, outcome.periods[0], outcome.periods[1]);
  }
}

Json cases(const char* file) {
  std::ifstream in(file);
  return Json::parse(in).at("cases");
}

// Prints the deviation from a stored case and returns it.
Real deviation(const Json& stored, const Outcome& outcome) {
  Real largest = 0;
  for (std::size_t i = 0; i < 3; ++i)
    largest = std::max(largest, abs(outcome.velocity[i] - stored["final"][i].get<double>()));
  bool same = true;
  for (std::size_t j = 0; j < 2; ++j)
    same = same && static_cast<std::size_t>(outcome.periods[j]) == stored["periods"][j].size();
  fmt::print("{:.2g} end {:.2g} {}\n", static_cast<double>(largest),
             static_cast<double>(abs(outcome.end - stored["time"].get<double>())),
             same ? "" : "periods differ");
  return largest;
}

int check(const char* triplets, const char* viscoelastic) {
  Real largest = 0;
  for (const auto& c : cases(triplets)) {
    if (c["law"] != "hertz") continue;
    fmt::print("hertz {} {} ", c["kappa"].get<double>(), c["velocity"][2].get<double>());
    largest = std::max(largest, deviation(c, impact({.stiffness = {1, c["kappa"].get<double>()},
                                                     .damping = 0,
                                                     .velocity = {1, 0, c["velocity"][2].get<double>()}})));
  }
  for (const auto& c : cases(viscoelastic)) {
    if (!c.contains("final") || c["exponent"] != 1.5) continue;
    fmt::print("viscoelastic {} ", c["damping"].get<double>());
    largest = std::max(
        largest,
        deviation(
            c, impact({.stiffness = {1, 1}, .damping = c["damping"].get<double>(), .velocity = {1, 0, 0}})));
  }
  fmt::print("largest deviation {:.2g}\n", static_cast<double>(largest));
  return largest < 1.2e-16L ? 0 : 1;  // the stored numbers are rounded to doubles
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "map") == 0) return map(), 0;
  if (argc == 2 && std::strcmp(argv[1], "viscoelastic") == 0) return viscoelastic(), 0;
  if (argc == 4 && std::strcmp(argv[1], "check") == 0) return check(argv[2], argv[3]);
  fmt::print(stderr, "usage: work_precision_reference map | viscoelastic | check TRIPLETS VISCO\n");
  return 2;
}
