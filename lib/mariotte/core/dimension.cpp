#include "mariotte/core/dimension.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace mariotte {
namespace {

std::string number(double value) {
  std::array<char, 32> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6).ptr;
  return {text.data(), end};
}

std::string in_base_units(const Dimension& dimension) {
  std::string text;
  for (const auto& [name, power] : {std::pair{"kg", dimension.kg}, {"m", dimension.m}, {"s", dimension.s}})
    if (power != 0)
      text += (text.empty() ? "" : " ") + std::string(name) + (power == 1 ? "" : "^" + number(power));
  return text;
}

struct Named {
  Dimension dimension;
  const char* name;
  const char* unit;
};

constexpr std::array named{
    Named{dimension::none, "a plain number", "1"},
    Named{dimension::length, "a length", "m"},
    Named{dimension::mass, "a mass", "kg"},
    Named{dimension::time, "a time", "s"},
    Named{dimension::velocity, "a velocity", "m/s"},
    Named{dimension::acceleration, "an acceleration", "m/s^2"},
    Named{dimension::pressure, "a pressure", "Pa"},
    Named{dimension::density, "a density", "kg/m^3"},
    Named{dimension::stiffness(0), "a force", "N"},
    Named{dimension::stiffness(1), "a stiffness", "N/m"},
    Named{dimension::damping(1), "a damping", "N s/m"},
    Named{{.kg = 1, .m = 2, .s = -2}, "an energy", "J"},
    Named{dimension::rate, "a rate", "rad/s"},
    Named{{.m = -1, .s = 1}, "an inverse velocity", "s/m"},
};

struct Words {
  std::string name, unit;
};

Words words(const Dimension& dimension) {
  for (const auto& one : named)
    if (same(dimension, one.dimension)) return {one.name, one.unit};
  const double exponent = 1 - dimension.m;
  if (same(dimension, dimension::stiffness(exponent))) return {"a stiffness", "N/m^" + number(exponent)};
  if (same(dimension, dimension::damping(exponent))) return {"a damping", "N s/m^" + number(exponent)};
  return {"", in_base_units(dimension)};
}

}  // namespace

bool same(const Dimension& a, const Dimension& b) {
  // Exponents are typed with a few digits: "m^0.333" is not meant to be "m^(1/3)", rounding is forgiven.
  const auto close = [](double x, double y) { return std::abs(x - y) < 1e-9; };
  return close(a.kg, b.kg) && close(a.m, b.m) && close(a.s, b.s);
}

std::string describe(const Dimension& dimension) {
  const auto [name, unit] = words(dimension);
  if (name.empty()) return "a quantity in " + unit;
  return unit == "1" ? name : name + " (" + unit + ")";
}

std::string unit_of(const Dimension& dimension) {
  return words(dimension).unit;
}

}  // namespace mariotte
