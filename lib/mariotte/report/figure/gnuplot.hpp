// What all gnuplot scripts share, and running them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace mariotte::report {

/// How every script begins: where figures go, how data files look, and the style.
std::string script_head();

/// Text for a script, on one line between single quotes.
std::string quoted(std::string text);

/// Size of a figure, in pixels of a screen on which its text is 13 high.
struct Sheet {
  int width;
  int height;
};
inline constexpr double letter_width = 7.2;      ///< mean, in these pixels
inline constexpr Sheet one_column = {450, 320};  ///< beside others of a page, or in a journal's column
inline constexpr Sheet wide = {680, 420};        ///< two columns of panels, or a legend beside one

/// Commands that make `name`.png, .svg and .pdf with `plot`, a plot command that ends its line.
std::string on_all_terminals(const std::string& name, const std::string& plot, const Sheet& sheet);

/// The files that these commands make.
std::vector<std::string> files_of_figure(const std::string& name);

/// The files that a script makes by these commands, without a folder; none if there is no script.
std::vector<std::string> figures_of_script(const std::filesystem::path& script);

/// "5.4 patchlevel 4", or empty if gnuplot is not installed.
std::string gnuplot_version();

/// Run plot.gp in `folder`; the figures, files of these names that it makes in the folder named by its
/// variable `folder`, appear all at once. Returns an empty text, or why there are no figures: gnuplot is not
/// installed, or it failed.
std::string draw(const std::filesystem::path& folder, const std::vector<std::string>& figures);

}  // namespace mariotte::report
