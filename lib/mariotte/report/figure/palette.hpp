// Colours of figures: lines that stay apart for every eye and in grey, and a map of even lightness.
#pragma once
#include <array>
#include <string>

namespace mariotte::report {

/// Of lines, in their order: those of Okabe & Ito (2008) that stand out on white, without their yellow.
inline constexpr std::array line_colours = {"#000000", "#0072b2", "#d55e00", "#009e73",
                                            "#cc79a7", "#e69f00", "#56b4e9"};

/// Dashes of lines, in gnuplot's numbers of drawn and left out lengths; empty for a solid line. They have
/// another period than the colours, so 28 lines differ.
inline constexpr std::array line_dashes = {"", "12,4", "3,3", "12,3,3,3"};

/// Marks of points, in gnuplot's numbers: disc, square, triangle, ring, diamond, open square, open triangle.
inline constexpr std::array line_marks = {7, 5, 9, 6, 13, 4, 8};

/// Eighths of viridis (van der Walt & Smith 2015, CC0): lightness grows evenly from dark to bright, as seen
/// with and without a sense of red or green, and in grey.
inline constexpr std::array map_colours = {"#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c",
                                           "#28ae80", "#5ec962", "#addc30", "#fde725"};

/// gnuplot's commands that set all of these: linetypes 1 … 28, and the palette.
std::string palette_settings();

}  // namespace mariotte::report
