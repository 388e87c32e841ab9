// Which values a sweep gives to which keys of a scene: axes, their grid, and what each point of it sets.
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/scene/node.hpp"
#include "mariotte/study/sweep/expression.hpp"

namespace mariotte::study {

/// How values are drawn: each by itself; one in each of `count` equal intervals, in random order (Latin
/// hypercube); or by the sequence of Sobol.
enum class Draw { independent, latin, sobol };

/// "random", "latin", "sobol".
constexpr const char* name(Draw draw) {
  return draw == Draw::latin ? "latin" : draw == Draw::sobol ? "sobol" : "random";
}

/// Values between two ends, which are among them unless they are drawn at random [SI].
struct Range {
  double from = 0;
  double to = 0;
  bool logarithmic = false;                ///< even ratios instead of even distances
  std::optional<std::uint64_t> seed = {};  ///< drawn at random instead of evenly spaced
  Draw draw = Draw::independent;
  bool normal = false;  ///< drawn from a normal distribution; the ends are its mean ∓ its deviation
};

/// Of a normal distribution [SI].
inline double mean(const Range& range) {
  return 0.5 * (range.from + range.to);
}
inline double deviation(const Range& range) {
  return 0.5 * (range.to - range.from);
}

/// One key that is varied. Parameters of one axis move together.
struct Parameter {
  std::string key;                     ///< as `--set` writes it
  std::string key_in_results = {};     ///< with the place of its ball or contact there, for figures
  scene::Place place = {};             ///< of the key in the scene file
  Index axis = 0;                      ///< whose position chooses the value
  std::optional<Range> range = {};     ///< or else
  std::vector<scene::Node> list = {};  ///< the values; numbers in SI
  bool is_variable = false;            ///< no key of the scene, but a name in expressions
  std::string unit = {};               ///< SI; "1" for a pure number, empty for text
};

/// What a name in an expression stands for.
struct Term {
  enum class Kind { constant, parameter, derived, result };

  Kind kind = Kind::constant;
  std::size_t which = 0;  ///< of the parameters, of what is derived, or of the numbers of a result
  double value = 0;       ///< of a constant, in SI
};

/// An expression, and what its names stand for.
struct Formula {
  Expression expression;
  std::vector<Term> terms;
};

/// A key that follows from others.
struct Derived {
  std::string key;
  scene::Place place;
  Formula formula;
};

struct Axis {
  Index count = 0;
  Index stride = 0;  ///< points from one position to the next
};

/// All points of a sweep: the grid of its axes, the last one fastest.
struct Design {
  std::vector<Parameter> parameters;
  std::vector<Axis> axes;
  std::vector<Derived> derived = {};  ///< each may use those before it

  Index points() const { return axes.empty() ? 0 : axes.front().count * axes.front().stride; }
};

/// The keys that are varied.
std::vector<std::string> keys(const Design& design);

/// Where on an axis a point lies, from 0.
Index position(const Axis& axis, Index point);

/// Whether all values of a parameter are numbers.
bool is_numeric(const Parameter& parameter);

/// What a point gives to the parameter of this number. A random value depends on the seed, on the number of
/// the parameter and on the position along its axis, and on nothing else.
scene::Node value(const Design& design, std::size_t parameter, Index point);

/// The same for a numeric parameter [SI].
double number(const Design& design, std::size_t parameter, Index point);

/// Of a formula at a point; `result` has the numbers that its terms may be of [SI].
double number(const Design& design, const Formula& formula, Index point, std::span<const double> result = {});

}  // namespace mariotte::study
