#include "figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/page/files.hpp"
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

std::string script(const Figure& figure, std::size_t first_block) {
  std::string plot = "plot";
  const auto curves = names(figure.rows, figure.curve);
  for (std::size_t i = 0; i < curves.size(); ++i)
    plot += fmt::format("{} 'plot.csv' index {} using 1:2 with linespoints lt {} title {} noenhanced",
                        i > 0 ? "," : "", first_block + i, i + 1, report::quoted(curves[i]));
  std::string text =
      fmt::format("\nset title {} noenhanced\nset xlabel {} noenhanced\nset ylabel '{}'\n",
                  report::quoted(figure.title), report::quoted(figure.along), label(figure.quantity));
  text += figure.quantity == Quantity::first_icr ? "unset logscale y\n"
                                                 : "set logscale y\nset format y '10^{%L}'\n";
  if (figure.quantity == Quantity::first_icr) text += "set format y '%g'\n";
  return text + report::on_all_terminals(figure.name, plot + "\n", report::wide);
}

constexpr const char* over_decades = "set logscale x\nset format x '10^{%L}'\n";

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
  std::string data = "# value that was varied, quantity shown; a block per curve\n",
              text = report::script_head();
  text += over_decades;
  std::vector<std::string> files = {"plot.csv", "plot.gp"}, pictures;
  std::size_t blocks = 0;
  for (const auto& figure : figures) {
    text += script(figure, blocks);
    for (const auto& curve : names(figure.rows, figure.curve)) {
      data += block(figure, curve);
      ++blocks;
    }
    const auto made = report::files_of_figure(figure.name);
    pictures.insert(pictures.end(), made.begin(), made.end());
  }
  report::prepare_folder(folder, files, /*overwrite=*/true);
  report::write_file(folder / "plot.csv", data);
  report::write_file(folder / "plot.gp", text);
  return figures.empty() ? "nothing was measured" : report::draw(folder, pictures);
}

}  // namespace mariotte::stiffness_study
