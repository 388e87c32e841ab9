#include "figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "mariotte/report/files.hpp"
#include "mariotte/report/plot.hpp"
#include "statement.hpp"

namespace mariotte::stiffness_study {
namespace {

using Quantity = Figure::Quantity;

double shown(const Row& row, Quantity quantity) {
  if (!(row.run.seconds > 0)) return std::numeric_limits<double>::quiet_NaN();
  switch (quantity) {
    case Quantity::seconds:
      return 1e6 * row.run.seconds;
    case Quantity::steps:
      return static_cast<double>(row.run.steps);
    case Quantity::first_icr:
      return row.run.icr.empty() || !row.run.icr[0] ? std::numeric_limits<double>::quiet_NaN()
                                                    : *row.run.icr[0];
  }
  return std::numeric_limits<double>::quiet_NaN();
}

const char* label(Quantity quantity) {
  switch (quantity) {
    case Quantity::seconds:
      return "CPU time [µs]";
    case Quantity::steps:
      return "steps";
    case Quantity::first_icr:
      return "α of contacts 1 and 2";
  }
  return "";
}

// gnuplot tells curves of a file apart by two blank lines between them.
std::string block(const Figure& figure, const std::string& curve) {
  std::string text;
  for (const auto& row : figure.rows)
    if (row.*figure.curve == curve && row.value > 0)
      if (const double value = shown(row, figure.quantity); value == value)
        text += fmt::format("{:.17g},{:.17g}\n", row.value, value);
  return (text.empty() ? "nan,nan\n" : text) + "\n\n";
}

std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 2) text.insert(at, 1, '\'');
  return "'" + text + "'";
}

std::string script(const Figure& figure, std::size_t first_block) {
  std::string plot = "plot";
  const auto curves = names(figure.rows, figure.curve);
  for (std::size_t i = 0; i < curves.size(); ++i)
    plot += fmt::format(
        "{} 'plot.csv' index {} using 1:2 with linespoints lw 2 ps 0.7 pt 7 lc {} title {} noenhanced",
        i > 0 ? "," : "", first_block + i, i + 1, quoted(curves[i]));
  std::string text = fmt::format("\nset title {} noenhanced\nset xlabel {} noenhanced\nset ylabel '{}'\n",
                                 quoted(figure.title), quoted(figure.along), label(figure.quantity));
  text += figure.quantity == Quantity::first_icr ? "unset logscale y\n"
                                                 : "set logscale y\nset format y '10^{%L}'\n";
  if (figure.quantity == Quantity::first_icr) text += "set format y '%g'\n";
  text += "set terminal pngcairo size 1200,750 font 'sans,14'\n";
  text += fmt::format("set output folder.'{}.png'\n{}\n", figure.name, plot);
  text += "set terminal svg size 800,500 dynamic font 'sans,13' background 'white'\n";
  text += fmt::format("set output folder.'{}.svg'\n{}\n", figure.name, plot);
  return text;
}

constexpr const char* preamble = R"(# Run with gnuplot in this folder.
if (!exists('folder')) folder = ''
set encoding utf8
set datafile separator comma
set border 3 lc rgb '#555555'
set tics nomirror out
set grid lt 1 lc rgb '#e6e6e6' lw 1
set key outside right top reverse Left samplen 2
set logscale x
set format x '10^{%L}'
set linetype 1 lc rgb '#30123b'
set linetype 2 lc rgb '#4171d6'
set linetype 3 lc rgb '#1fb5b0'
set linetype 4 lc rgb '#5fb94a'
set linetype 5 lc rgb '#e0a11b'
set linetype 6 lc rgb '#c4391d'
set linetype 7 lc rgb '#8c564b'
set linetype 8 lc rgb '#7f7f7f'
)";

// "Hertz triplet" as part of the name of a file.
std::string file_name(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return text;
}

}  // namespace

std::vector<Figure> figures_by_flow(const Rows& rows, const std::string& along, Quantity quantity) {
  std::vector<Figure> figures;
  for (const auto& series : names(rows, &Row::series)) {
    auto some = select(rows, [&](const Row& row) { return row.series == series; });
    const auto study = some.front().study;
    figures.push_back({study + "_" + file_name(series) + (quantity == Quantity::steps ? "_steps" : "_time"),
                       series, along, quantity, &Row::flow, std::move(some)});
  }
  return figures;
}

std::string draw(const std::filesystem::path& folder, const std::vector<Figure>& figures) {
  std::string data = "# value that was varied, quantity shown; a block per curve\n", text = preamble;
  std::vector<std::string> files = {"plot.csv", "plot.gp"}, pictures;
  std::size_t blocks = 0;
  for (const auto& figure : figures) {
    text += script(figure, blocks);
    for (const auto& curve : names(figure.rows, figure.curve)) {
      data += block(figure, curve);
      ++blocks;
    }
    pictures.insert(pictures.end(), {figure.name + ".png", figure.name + ".svg"});
  }
  report::prepare_folder(folder, files, /*overwrite=*/true);
  report::write_file(folder / "plot.csv", data);
  report::write_file(folder / "plot.gp", text);
  return figures.empty() ? "nothing was measured" : report::draw(folder, pictures);
}

}  // namespace mariotte::stiffness_study
