// Data and script of a picture for gnuplot.
#pragma once
#include <string>

#include "figure.hpp"

namespace mariotte::paper_figures {

/// `plot.csv`: x and y, a block per curve under its name.
std::string plot_data(const Picture& picture);

/// `plot.gp`, which makes `name`.png and `name`.svg.
std::string plot_script(const Picture& picture, const std::string& name);

}  // namespace mariotte::paper_figures
