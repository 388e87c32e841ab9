// What all gnuplot scripts share, and running them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mariotte/report/number.hpp"

namespace mariotte::report {

/// How every script begins: where figures go, how data files look, and the style.
extern const char* const script_head;

/// Labels the horizontal axis as time, from `start` to `end` [s], and sets `time_factor` from seconds to its
/// unit.
std::string time_axis(const Display& time, double start, double end);

/// Text for a script, on one line between single quotes.
std::string quoted(std::string text);

/// Commands that make `name`.png and `name`.svg with `plot`, a plot command that ends its line.
std::string on_both_terminals(const std::string& name, const std::string& plot);

/// The two files that these commands make.
std::vector<std::string> files_of_figure(const std::string& name);

/// "5.4 patchlevel 4", or empty if gnuplot is not installed.
std::string gnuplot_version();

/// Run plot.gp in `folder`; the figures, files of these names that it makes in the folder named by its
/// variable `folder`, appear all at once. Returns an empty text, or why there are no figures: gnuplot is not
/// installed, or it failed.
std::string draw(const std::filesystem::path& folder, const std::vector<std::string>& figures);

}  // namespace mariotte::report
