#define BOOST_TEST_MODULE report_palette
#include <array>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "mariotte/report/figure/palette.hpp"

using namespace mariotte;

namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

constexpr Matrix everyone = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
// Of linear red, green and blue, at full severity: Machado, Oliveira & Fernandes 2009, table 1.
constexpr Matrix protanopia = {
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix deuteranopia = {
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};

Triple times(const Matrix& matrix, const Triple& x) {
  Triple y{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) y[i] += matrix[i][k] * x[k];
  return y;
}

/// Linear red, green and blue of "#rrggbb" (IEC 61966-2-1).
Triple linear(const std::string& colour) {
  Triple rgb{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double c = std::stoi(colour.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
    rgb[k] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

/// CIELAB under D65.
Triple lab(const Triple& rgb) {
  constexpr Matrix to_xyz = {{{0.4124, 0.3576, 0.1805}, {0.2126, 0.7152, 0.0722}, {0.0193, 0.1192, 0.9505}}};
  constexpr Triple white = {0.9505, 1, 1.089};
  auto f = times(to_xyz, rgb);
  for (std::size_t k = 0; k < 3; ++k) {
    const double t = f[k] / white[k];
    f[k] = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double distance(const std::string& a, const std::string& b, const Matrix& eye) {
  const auto x = lab(times(eye, linear(a))), y = lab(times(eye, linear(b)));
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

double lightness(const std::string& colour, const Matrix& eye) {
  return lab(times(eye, linear(colour)))[0];
}

}  // namespace

// Two colours side by side differ to the eye from 2.3 on (Mahy et al. 1994); thin lines apart need several
// times that.
BOOST_AUTO_TEST_CASE(seven_lines_are_apart_for_eyes_without_red_or_green) {
  for (const auto& eye : {everyone, protanopia, deuteranopia})
    for (std::size_t i = 0; i < report::line_colours.size(); ++i)
      for (std::size_t k = 0; k < i; ++k)
        BOOST_TEST(distance(report::line_colours[i], report::line_colours[k], eye) > 12,
                   report::line_colours[i]
                       << " " << report::line_colours[k] << " "
                       << distance(report::line_colours[i], report::line_colours[k], eye));
}

BOOST_AUTO_TEST_CASE(lines_that_grey_brings_together_have_other_dashes) {
  for (std::size_t i = 0; i < report::line_colours.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const double grey =
          lightness(report::line_colours[i], everyone) - lightness(report::line_colours[k], everyone);
      const auto dashes = report::line_dashes.size();
      BOOST_TEST((std::abs(grey) > 10 || i % dashes != k % dashes), i << " and " << k << ": " << grey);
    }
}

BOOST_AUTO_TEST_CASE(lightness_of_the_map_grows_evenly_for_every_eye) {
  const auto& map = report::map_colours;
  const auto count = static_cast<double>(map.size() - 1);
  for (const auto& eye : {everyone, protanopia, deuteranopia}) {
    const double mean = (lightness(map.back(), eye) - lightness(map.front(), eye)) / count;
    BOOST_TEST(mean > 9);
    for (std::size_t i = 1; i < map.size(); ++i) {
      const double step = lightness(map[i], eye) - lightness(map[i - 1], eye);
      BOOST_TEST((step > 0.5 * mean && step < 1.5 * mean), i << ": " << step << " of " << mean);
    }
  }
}

BOOST_AUTO_TEST_CASE(no_two_of_28_lines_share_colour_and_dashes) {
  const auto settings = report::palette_settings();
  BOOST_TEST(settings.find("set linetype 28 ") != std::string::npos);
  BOOST_TEST(settings.find("set linetype 29 ") == std::string::npos);
  std::vector<std::string> seen;
  for (std::size_t from = 0, at; (at = settings.find(" lc ", from)) != std::string::npos; from = at + 1) {
    const auto look = settings.substr(at, settings.find(" pt ", at) - at);
    for (const auto& other : seen) BOOST_TEST(look != other);
    seen.push_back(look);
  }
  BOOST_TEST(seen.size() == 28u);
}
