#include "mariotte/scene/figure_reader.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 5> figure_keys{"window", "balls", "contacts", "logarithmic",
                                                      "contours"};
constexpr Index most_contours = 50, most_curves = 12, largest_number = 10'000'000;

std::array<double, 2> read_window(const Source& source, const Field& field) {
  const auto times = numbers(source, field, dimension::time, Domain::not_negative);
  expect_length(source, field, times.size(), 2);
  if (!(times[0] < times[1]))
    reject(source, field, fault::out_of_range, "must end after it begins: [\"30 us\", \"90 us\"]");
  return {times[0], times[1]};
}

/// Numbers of balls or contacts, each once.
std::vector<Index> read_places(const Source& source, const Field& field) {
  if (!field.node->array()) reject(source, field, fault::wrong_type, "must be a list of numbers, as [1, 20]");
  const auto count = std::ssize(*field.node->array());
  if (count == 0 || count > most_curves)
    reject(source, field, fault::out_of_range,
           "must have from 1 to " + std::to_string(most_curves) + " numbers, a curve each");
  std::vector<Index> places;
  for (Index i = 0; i < count; ++i) {
    const auto one = element(field, i);
    places.push_back(whole(source, one, 1, largest_number));
    if (std::find(places.begin(), places.end() - 1, places.back()) != places.end() - 1)
      reject(source, one, fault::contradiction, std::to_string(places.back()) + " stands there twice");
  }
  return places;
}

}  // namespace

Figure read_figure(const Source& source, const Field& figure) {
  expect_keys(source, figure, figure_keys);
  Figure options;
  if (const auto field = find(figure, "window")) options.window = read_window(source, *field);
  if (const auto field = find(figure, "balls")) options.balls = read_places(source, *field);
  if (const auto field = find(figure, "contacts")) options.contacts = read_places(source, *field);
  if (const auto field = find(figure, "logarithmic")) options.logarithmic = boolean(source, *field);
  if (const auto field = find(figure, "contours")) options.contours = whole(source, *field, 0, most_contours);
  return options;
}

}  // namespace mariotte::scene
