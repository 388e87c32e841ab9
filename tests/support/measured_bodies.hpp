// Bodies as they are measured: exact restitution, and the same with noise.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "mariotte/study/fit/fit.hpp"
#include "support/noise.hpp"

namespace mariotte::test {

/// Guesses of ζ's; the truth of the tests is another.
inline const std::string sphere = R"([body]
shape = "sphere"
radius = "2.45 um"
density = "1350 kg/m^3"
[surface]
law = "brach-dunn"
stiffness = "1.74 GPa"
work_of_adhesion = "0.38 J/m^2"
zeta_hertz = 1
zeta_adhesion = 1
[incidence]
normal_speed = "5 m/s"
angles = [0, 0, 0]
)";

/// The text with the first `from` replaced.
inline std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

inline const std::string rod = with(with(sphere, "\"sphere\"", "\"rod\"\nlength_ratio = 10"), "[incidence]",
                                    "friction = 0.3\n[incidence]");

inline const std::vector<std::string> dampings = {"surface.zeta_hertz", "surface.zeta_adhesion"};

/// `count` speeds between these [m/s], in even ratios.
inline std::vector<double> speeds(double from, double to, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from * std::pow(to / from, i / (count - 1.0)));
  return all;
}

/// A table of spheres of these diameters [µm] at all speeds, whose restitution is still to be measured.
inline std::string table_of(const std::vector<double>& diameters, const std::vector<double>& at) {
  std::string text = "diameter [um],speed [m/s],restitution\n";
  for (const double diameter : diameters)
    for (const double speed : at) text += fmt::format("{},{:.17g},0\n", diameter, speed);
  return text;
}

/// The table with the restitution that the scene with these overrides predicts.
inline study::Measurements exact(const std::string& scene, const scene::Overrides& truth,
                                 const std::string& table) {
  auto measured = study::parse_measurements(table, "data.csv");
  study::FitModel model(scene::parse_document(scene, "scene.toml", truth), {}, measured);
  for (std::size_t row = 0; row < measured.rows.size(); ++row)
    measured.rows[row].measured = model.of_row(row, {}).value;
  return measured;
}

inline study::Measurements noisy(study::Measurements measured, double deviation, std::uint64_t seed) {
  for (std::size_t row = 0; row < measured.rows.size(); ++row)
    measured.rows[row].measured += deviation * normal(seed, row);
  return measured;
}

inline study::Fit fitted(const std::string& scene, const study::Measurements& measured,
                         const std::vector<std::string>& free, bool differences = false) {
  study::FitModel model(scene::parse_document(scene, "scene.toml"), free, measured);
  if (differences) model.leave_out_slopes();
  return study::fit(model, free);
}

}  // namespace mariotte::test
