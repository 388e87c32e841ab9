// Physical dimensions as exponents of kg, m and s.
#pragma once
#include <string>

namespace mariotte {

/// Exponents of kg, m and s; they may be fractional. Angles have none.
struct Dimension {
  double kg = 0;
  double m = 0;
  double s = 0;
};

/// True if the exponents agree, up to rounding of fractions.
bool same(const Dimension& a, const Dimension& b);

namespace dimension {
inline constexpr Dimension none{};
inline constexpr Dimension length{.m = 1};
inline constexpr Dimension mass{.kg = 1};
inline constexpr Dimension time{.s = 1};
inline constexpr Dimension velocity{.m = 1, .s = -1};
inline constexpr Dimension acceleration{.m = 1, .s = -2};
inline constexpr Dimension energy{.kg = 1, .m = 2, .s = -2};
inline constexpr Dimension pressure{.kg = 1, .m = -1, .s = -2};
inline constexpr Dimension density{.kg = 1, .m = -3};
inline constexpr Dimension inertia{.kg = 1, .m = 2};
inline constexpr Dimension rate{.s = -1};

/// Of k in f = k δⁿ [N/m^n].
constexpr Dimension stiffness(double exponent) {
  return {.kg = 1, .m = 1 - exponent, .s = -2};
}
/// Of c in f = c δ^{n−1} δ̇ [N s/m^n].
constexpr Dimension damping(double exponent) {
  return {.kg = 1, .m = 1 - exponent, .s = -1};
}
}  // namespace dimension

/// "a length (m)", "a stiffness (N/m^1.5)", "a plain number", or base units for what has no name.
std::string describe(const Dimension& dimension);

/// "m", "N/m^1.5", "1" for a plain number, or base units, as "kg^2 m".
std::string unit_of(const Dimension& dimension);

}  // namespace mariotte
