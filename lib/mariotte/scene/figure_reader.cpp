#include "mariotte/scene/figure_reader.hpp"

#include <array>

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 3> figure_keys{"window", "logarithmic", "contours"};
constexpr Index most_contours = 50;

std::array<double, 2> read_window(const Source& source, const Field& field) {
  const auto times = numbers(source, field, dimension::time, Domain::not_negative);
  expect_length(source, field, times.size(), 2);
  if (!(times[0] < times[1]))
    reject(source, field, fault::out_of_range, "must end after it begins: [\"30 us\", \"90 us\"]");
  return {times[0], times[1]};
}

}  // namespace

Figure read_figure(const Source& source, const Field& figure) {
  expect_keys(source, figure, figure_keys);
  Figure options;
  if (const auto field = find(figure, "window")) options.window = read_window(source, *field);
  if (const auto field = find(figure, "logarithmic")) options.logarithmic = boolean(source, *field);
  if (const auto field = find(figure, "contours")) options.contours = whole(source, *field, 0, most_contours);
  return options;
}

}  // namespace mariotte::scene
