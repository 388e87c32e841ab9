#include "mariotte/report/figure/axis_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>
#include <utility>
#include <vector>

namespace mariotte::report {
namespace {

struct AxisWord {
  std::string_view key, words, symbol;
};
/// Keys that are not the words themselves, and symbols of what a scene says.
constexpr std::array<AxisWord, 20> dictionary{{
    {"icr", "impulse correlation ratio", ""},
    {"mass", "mass", "m"},
    {"diameter", "diameter", "d"},
    {"radius", "radius", "r"},
    {"gap", "gap", "g"},
    {"velocity", "initial velocity", "v⁻"},
    {"spin", "initial spin", "ω⁻"},
    {"angles", "angle", "α, β, γ"},
    {"angle", "angle", "φ"},
    {"normal_speed", "incident normal speed", "v_n"},
    {"tangential_velocity", "tangential velocity", "v_2, v_3"},
    {"stiffness", "stiffness", "k"},
    {"damping", "damping", "c"},
    {"exponent", "exponent", "n"},
    {"young", "Young's modulus", "E"},
    {"poisson", "Poisson's ratio", "ν"},
    {"density", "density", "ρ"},
    {"friction", "friction", "μ"},
    {"zeta_hertz", "damping", "ζ_H"},
    {"zeta_adhesion", "damping", "ζ_A"},
}};

const AxisWord* find(std::span<const AxisWord> words, std::string_view key) {
  const auto found =
      std::find_if(words.begin(), words.end(), [&](const AxisWord& one) { return one.key == key; });
  return found == words.end() ? nullptr : &*found;
}

/// A key taken apart: {"contacts", "peak_force"} and its indices, from 1; those from the end are 0, −1, …
struct Path {
  std::vector<std::string> names;
  std::vector<int> numbers;

  /// "2,1", or "n", "n−1" from the end, where there are so many `fewer` than balls.
  std::string number(int fewer = 0) const {
    std::string text;
    for (const int one : numbers)
      text += (text.empty() ? "" : ",") + (one > 0        ? std::to_string(one)
                                           : one == fewer ? "n"
                                                          : fmt::format("n−{}", fewer - one));
    return text;
  }
};

Path path_of(const std::string& key) {
  Path path{{""}, {}};
  for (std::size_t i = 0; i < key.size(); ++i)
    if (key[i] == '.')
      path.names.emplace_back();
    else if (key[i] == '[')
      path.numbers.push_back(std::atoi(key.c_str() + i + 1) + 1), i = std::min(key.find(']', i), key.size());
    else
      path.names.back() += key[i];
  return path;
}

std::string spaced(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// "e_nm" is "e_{nm}": gnuplot takes one letter else.
std::string with_braces(std::string text) {
  const auto mark = text.find('_');
  if (mark == text.npos || mark + 2 >= text.size() || text[mark + 1] == '{') return text;
  const auto end = std::min(text.find_first_of(" ,", mark), text.size());
  if (end > mark + 2) text.insert(end, "}").insert(mark + 1, "{");
  return text;
}

/// With an index at its end, before the minus of "v⁻": one above the other, the minus strays in SVG.
std::string with_index(const std::string& text, const std::string& index) {
  constexpr std::string_view before = "⁻";
  if (!text.ends_with(before)) return fmt::format("{}_{{{}}}", text, index);
  return fmt::format("{}_{{{}}}^{{−}}", text.substr(0, text.size() - before.size()), index);
}

/// "α_j" of number 2 is "α_{2}", "max f_n" is "max f_{n,2}", and of "α, β, γ" it is β.
std::string numbered(std::string_view symbol, const Path& path) {
  std::string text(symbol);
  if (text.empty() || path.numbers.empty()) return with_braces(text);
  if (text.find(", ") != text.npos) {
    for (int skipped = 1; skipped < path.numbers.back(); ++skipped) text.erase(0, text.find(", ") + 2);
    return text.substr(0, text.find(", "));
  }
  const auto mark = text.find('_');
  if (mark == text.npos) return with_index(text, path.number());
  const char letter = text[mark + 1];
  const auto before = letter == 'i' || letter == 'j' ? "" : fmt::format("{},", letter);
  const int fewer = letter != 'j' ? 0 : path.names.front() == "icr" ? 2 : 1;  // ratios, contacts
  return text.replace(mark, 2, fmt::format("_{{{}{}}}", before, path.number(fewer)));
}

std::string words_of_result(const Path& path) {
  const auto& first = path.names.front();
  const auto last = spaced(path.names.back());
  if (last == "count" && path.names.size() > 1)
    return "number of " + spaced(path.names[path.names.size() - 2]);
  if (const auto* known = find(dictionary, first)) return std::string(known->words);
  if (first == "final") return "final " + last;
  if (last == "ratio lab") return "energy ratio";
  if (last == "ratio centre") return "energy ratio in the mass-centre frame";
  const bool qualifies = first == "energy" || first == "momentum" || first == "restitution";
  return qualifies && path.names.size() > 1 ? last + " " + first : last;
}

std::string joined(const std::string& words, const std::string& symbol, const Path& path) {
  if (!symbol.empty()) return words + " " + symbol;
  return path.numbers.empty() ? words : words + " " + path.number();
}

}  // namespace

std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (std::string_view("_^{}@&~\\").find(c) != std::string_view::npos) escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string greek(const std::string& name) {
  constexpr std::array<std::pair<std::string_view, const char*>, 16> letters{{{"alpha", "α"},
                                                                              {"beta", "β"},
                                                                              {"gamma", "γ"},
                                                                              {"delta", "δ"},
                                                                              {"epsilon", "ε"},
                                                                              {"zeta", "ζ"},
                                                                              {"eta", "η"},
                                                                              {"theta", "θ"},
                                                                              {"kappa", "κ"},
                                                                              {"lambda", "λ"},
                                                                              {"mu", "μ"},
                                                                              {"nu", "ν"},
                                                                              {"rho", "ρ"},
                                                                              {"sigma", "σ"},
                                                                              {"tau", "τ"},
                                                                              {"omega", "ω"}}};
  const auto mark = std::min(name.find('_'), name.size());
  for (const auto& [word, letter] : letters)
    if (name.substr(0, mark) == word)
      return mark == name.size() ? letter : fmt::format("{}_{{{}}}", letter, plain(name.substr(mark + 1)));
  return plain(name);
}

std::string name_of_result(const std::string& key, std::string_view symbol) {
  const auto path = path_of(key);
  return joined(words_of_result(path), numbered(symbol, path), path);
}

std::string short_name_of_result(const std::string& key, std::string_view symbol) {
  return symbol.empty() ? name_of_result(key, symbol) : numbered(symbol, path_of(key));
}

std::string name_of_input(const std::string& key) {
  const auto path = path_of(key);
  const auto* known = find(dictionary, path.names.back());
  if (!known) return joined(spaced(path.names.back()), "", path);
  return joined(std::string(known->words), numbered(known->symbol, path), path);
}

std::string name_of_slope(const std::string& key) {
  constexpr std::array<AxisWord, 5> outcomes{{{"velocity", "", "v"},
                                              {"impulse", "", "p"},
                                              {"icr", "", "α"},
                                              {"time", "", "t"},
                                              {"dissipated", "", "D"}}};
  const auto dot = key.find('.', key.find('.') + 1);
  const auto outcome = path_of(key.substr(0, dot)), parameter = path_of(key.substr(dot + 1));
  const auto* of = find(outcomes, outcome.names.back());
  const auto* by = find(dictionary, parameter.names.back());
  const auto by_words = joined(spaced(parameter.names.back()), "", parameter);
  return fmt::format("∂{}/∂{}", of ? numbered(of->symbol, outcome) : outcome.names.back(),
                     by && !by->symbol.empty() ? numbered(by->symbol, parameter) : by_words);
}

std::string with_unit(const std::string& name, const std::string& unit) {
  if (unit.empty() || unit == "1") return name;
  std::string text = unit;
  for (auto power = text.find('^'); power != text.npos; power = text.find('^', power + 1)) {
    text.insert(std::min(text.find_first_of(" /", power), text.size()), "}");
    text.insert(power + 1, "{");
  }
  return fmt::format("{}\u00a0[{}]", name, text);  // browsers drop a blank after an index
}

}  // namespace mariotte::report
