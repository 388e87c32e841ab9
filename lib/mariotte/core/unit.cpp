#include "mariotte/core/unit.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "mariotte/core/nearest.hpp"
#include "mariotte/core/quantity.hpp"

namespace mariotte {
namespace {

struct Unit {
  std::string_view name;
  UnitFactor si;
  bool prefixed;  ///< takes "k", "m", …
};

constexpr double pi = std::numbers::pi;

constexpr std::array units{
    Unit{"m", {1, 1, dimension::length}, true},
    Unit{"g", {1, 1e3, dimension::mass}, true},
    Unit{"s", {1, 1, dimension::time}, true},
    Unit{"N", {1, 1, {.kg = 1, .m = 1, .s = -2}}, true},
    Unit{"Pa", {1, 1, dimension::pressure}, true},
    Unit{"J", {1, 1, {.kg = 1, .m = 2, .s = -2}}, true},
    Unit{"W", {1, 1, {.kg = 1, .m = 2, .s = -3}}, true},
    Unit{"Hz", {1, 1, {.s = -1}}, true},
    Unit{"rad", {1, 1, dimension::none}, true},
    Unit{"deg", {pi, 180, dimension::none}, false},
    Unit{"°", {pi, 180, dimension::none}, false},
    Unit{"min", {60, 1, dimension::time}, false},
    Unit{"h", {3600, 1, dimension::time}, false},
    Unit{"t", {1e3, 1, dimension::mass}, false},
    Unit{"bar", {1e5, 1, dimension::pressure}, false},
};

struct Prefix {
  std::string_view name;
  int power;  ///< of ten
};

constexpr std::array prefixes{
    Prefix{"p", -12}, Prefix{"n", -9}, Prefix{"u", -6}, Prefix{"\u00b5", -6}, Prefix{"\u03bc", -6},
    Prefix{"m", -3},  Prefix{"c", -2}, Prefix{"d", -1}, Prefix{"h", 2},       Prefix{"k", 3},
    Prefix{"M", 6},   Prefix{"G", 9},  Prefix{"T", 12},
};

/// What people write, for suggestions only.
constexpr std::array<std::string_view, 38> common{
    "m",  "mm",  "cm", "km", "um", "nm", "kg", "g",   "mg",  "ug",   "s",   "ms",  "us",
    "ns", "min", "h",  "N",  "kN", "mN", "MN", "uN",  "Pa",  "kPa",  "MPa", "GPa", "J",
    "mJ", "uJ",  "nJ", "kJ", "W",  "kW", "Hz", "kHz", "rad", "mrad", "deg", "bar"};

UnitFactor times(const UnitFactor& a, const UnitFactor& b, double power) {
  const double up = std::pow(power < 0 ? b.down : b.up, std::abs(power));
  const double down = std::pow(power < 0 ? b.up : b.down, std::abs(power));
  return {a.up * up,
          a.down * down,
          {a.dimension.kg + power * b.dimension.kg, a.dimension.m + power * b.dimension.m,
           a.dimension.s + power * b.dimension.s}};
}

std::optional<UnitFactor> find_unit(std::string_view word) {
  for (const auto& unit : units)
    if (word == unit.name) return unit.si;
  for (const auto& unit : units)
    for (const auto& prefix : prefixes)
      if (unit.prefixed && word.size() == prefix.name.size() + unit.name.size() &&
          word.starts_with(prefix.name) && word.ends_with(unit.name))
        return times(unit.si, {10, 1, dimension::none}, prefix.power);
  return {};
}

/// Recursive descent over the grammar in the header.
class UnitParser {
 public:
  explicit UnitParser(std::string_view text) : text_(text), rest_(text) {}

  UnitFactor all() {
    const auto unit = product();
    if (!rest_.empty()) bad();
    return unit;
  }

 private:
  UnitFactor product() {
    if (++depth_ > 8) bad();
    auto result = rest_.starts_with('/') ? UnitFactor{} : factor();
    bool divided = false;
    for (skip(); !rest_.empty() && rest_.front() != ')'; skip()) {
      const bool divide = take("/");
      if (!divide && !take("*")) take("·");
      if (!divide && divided)
        throw QuantityError("ambiguous unit " + quoted(text_) + ": put what '/' divides by in parentheses",
                            fault::unknown_unit);
      divided = divide;
      result = times(result, factor(), divide ? -1 : 1);
    }
    --depth_;
    return result;
  }

  UnitFactor factor() {
    skip();
    UnitFactor base;
    if (take("(")) {
      base = product();
      if (!take(")")) bad();
    } else if (!take("1")) {
      base = name();
    }
    return times({}, base, power());
  }

  UnitFactor name() {
    std::size_t size = 0;
    while (size < rest_.size() &&
           std::string_view(" */^()0123456789.+-").find(rest_[size]) == std::string_view::npos &&
           !ends_name(rest_.substr(size)))
      ++size;
    const auto word = rest_.substr(0, size);
    if (word.empty()) bad();
    const auto unit = find_unit(word);
    if (!unit)
      throw QuantityError("unknown unit " + quoted(word) + suggestion(word, common), fault::unknown_unit);
    rest_.remove_prefix(size);
    return *unit;
  }

  static bool ends_name(std::string_view text) {
    return text.starts_with("·") || text.starts_with("²") || text.starts_with("³");
  }

  double power() {
    if (take("²")) return 2;
    if (take("³")) return 3;
    if (!take("^")) return 1;
    if (!take("(")) return decimal();
    double value = decimal();
    if (take("/")) value /= decimal();
    if (!take(")") || !std::isfinite(value)) bad();
    return value;
  }

  double decimal() {
    double value = 0;
    const bool negative = take("-");
    if (rest_.empty() || rest_.front() < '0' || rest_.front() > '9') bad();
    const auto [end, error] =
        std::from_chars(rest_.data(), rest_.data() + rest_.size(), value, std::chars_format::fixed);
    if (error != std::errc() || value > 16) bad();
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    return negative ? -value : value;
  }

  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }

  void skip() {
    while (take(" ")) {
    }
  }

  [[noreturn]] void bad() const {
    throw QuantityError("cannot read the unit " + quoted(text_), fault::unknown_unit);
  }

  std::string_view text_;
  std::string_view rest_;
  int depth_ = 0;
};

}  // namespace

UnitFactor parse_unit(std::string_view text) {
  return UnitParser(text).all();
}

std::string quoted(std::string_view text) {
  return "'" + std::string(text) + "'";
}

}  // namespace mariotte
