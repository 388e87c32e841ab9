// Numbers as text: exact for programs, scaled and aligned for people. Zero has no sign.
#pragma once
#include <span>
#include <string>
#include <string_view>

namespace mariotte::report {

/// 17 significant digits, enough to give back the same double; "inf", "-inf" or "nan" if it is not finite.
std::string exact(double value);
/// The same, at the end of a text.
void append_exact(double value, std::string& text);
/// With so many significant digits.
void append_rounded(double value, int digits, std::string& text);
std::string rounded(double value, int digits);
/// With so many digits after the point.
std::string fixed(double value, int decimals);

/// How the numbers of one column or axis are shown: multiplied by `factor`, in `unit`, with `decimals`.
struct Display {
  double factor;     ///< shown number = factor × SI value
  std::string unit;  ///< with its prefix, for example "µs"
  int decimals;      ///< digits after the point
};

/// Whether an SI prefix may stand before it: not before one of kilograms, of a power as "m^2", or of a rate
/// "1/s".
bool takes_prefix(std::string_view unit);

/// A display with eight significant digits for the largest finite magnitude among `values`, and an SI prefix
/// where that magnitude is below 0.1 or from 10⁴ on. Times in "s" get no prefix above one, small or
/// large "kg" are grams; without a unit values are of several, shown as they are in "SI".
Display display_for(std::span<const double> values, const std::string& unit);

/// `value` [SI] as the display shows it; a value too small for its decimals is shown as a power of ten.
std::string shown(const Display& display, double value);

}  // namespace mariotte::report
