// Numbers of 113 bits, and the few functions of them that are needed: the standard library knows none.
#pragma once
#include <quadmath.h>

#include <string>

namespace mariotte::reference {

using Real = __float128;

inline Real sqrt(Real x) {
  return ::sqrtq(x);
}
inline Real abs(Real x) {
  return ::fabsq(x);
}
inline Real pow(Real x, Real y) {
  return ::powq(x, y);
}

/// 20 significant digits.
inline std::string digits(Real x) {
  char text[64];
  ::quadmath_snprintf(text, sizeof text, "%.20Qg", x);
  return text;
}

}  // namespace mariotte::reference
