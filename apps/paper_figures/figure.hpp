// A figure of a paper as computed here: its curves, the numbers it rests on, and what the paper says about
// it.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace mariotte::paper_figures {

/// A number that is known from elsewhere.
struct Check {
  std::string what;
  double computed;
  double expected;
  double allowed;  ///< difference
};

/// False for numbers that are not finite.
bool holds(const Check& check);

enum class Verdict { yes, partly, no };

inline Verdict yes_if(bool holds) {
  return holds ? Verdict::yes : Verdict::no;
}

/// What the paper says, whether it is so, and what shows it.
struct Claim {
  std::string text;
  Verdict verdict;
  std::string finding;
};

enum class Style { line, dashed, points, line_and_points };

struct Curve {
  std::string name;  ///< empty: not in the legend
  Style style = Style::line;
  std::vector<double> x = {}, y = {};
  std::optional<double> colour = {};  ///< place on the palette, 0 … 1; without it curves have colours in turn
};

struct Picture {
  std::string title;
  std::string x_label, y_label;
  std::string commands;  ///< of gnuplot, before the curves are drawn
  std::vector<Curve> curves;
};

struct Reproduction {
  Picture picture;
  std::vector<Check> checks;
  std::vector<Claim> claims;
  std::string remark;  ///< how it differs from the printed figure; may be empty
};

struct Figure {
  std::string name;  ///< of the command line and of its folder
  std::string title;
  std::function<Reproduction()> make;
};

/// All of them, in the order of the papers.
const std::vector<Figure>& figures();

}  // namespace mariotte::paper_figures
