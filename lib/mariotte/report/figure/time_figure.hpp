// Figures over time: curves with their names beside them, event marks, and one panel per window.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/report/figure/window.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/scene/figure.hpp"

namespace mariotte::report {

/// One curve: where gnuplot finds it, and its values, which say where there is room for its name.
struct Curve {
  std::string name;  ///< in gnuplot's enhanced text
  std::string data;  ///< "'plot.csv' index 2"
  int time_column;   ///< from 1
  int value_column;
  std::vector<double> value;  ///< at the times of the figure
};

/// Where names stand: at the right end of the curves, or above their greatest magnitude.
enum class Names { at_end, at_peak };

/// Some curves over one time axis.
struct TimeFigure {
  std::string file;  ///< without its ending
  std::string title;
  std::string quantity;  ///< with its symbol: "force f"
  std::string unit;      ///< SI; empty where units differ
  Names names = Names::at_end;
  std::vector<double> time;   ///< [s]
  std::vector<Curve> curves;  ///< at least one
};

/// What the figures of a run share.
struct TimeAxis {
  Display display;
  std::vector<Window> windows;
  std::vector<impact::Event> events;
  bool is_chosen = false;              ///< by a user, who wants to see nothing else
  std::vector<Window> strongest = {};  ///< those that forces are drawn in, if not in all
  std::string about_strongest = {};    ///< the note there
  std::string note = {};               ///< behind the name of the axis
};

/// Over the windows of the action, or over the one that a user wants.
TimeAxis time_axis(const Action& action, std::vector<impact::Event> events, const scene::Figure& figure);

/// The axis of forces: impacts that are many and far apart would be lines on one axis.
TimeAxis axis_of_forces(const TimeAxis& axis);

/// Curves that cannot be told apart: positions of `figure.curves`, in groups in the order of their first.
/// They are drawn once, with the names of all.
std::vector<std::vector<std::size_t>> coincident(const TimeFigure& figure);

/// gnuplot commands that make the figure, to follow `script_head`.
std::string script(const TimeFigure& figure, const TimeAxis& axis);

/// One panel: its window, and its edges as parts of the sheet.
struct Panel {
  Window window;
  double left;
  double right;
  bool is_first;
  bool is_last;
};

/// The panels of a figure whose right margin is `margin` pixels wide. Each is as long as its window, but for
/// short ones, which stay wide enough to be read.
std::vector<Panel> panels(const std::vector<Window>& windows, double margin);

/// What stands beside the vertical axis, left of the longest number.
std::string vertical_name(const std::string& text);

/// gnuplot commands for one figure of several panels; `inside` says what each of them shows.
std::string on_panels(const std::string& file, const std::string& title, const TimeAxis& axis,
                      const std::vector<Panel>& panels,
                      const std::function<std::string(const Panel&)>& inside);

}  // namespace mariotte::report
