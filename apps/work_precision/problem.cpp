#include "problem.hpp"

#include <algorithm>

#include "body_table.hpp"
#include "mariotte/core/error.hpp"
#include "measuring/reference_table.hpp"
#include "reference_tables.hpp"

namespace mariotte::work_precision {

using measuring::Fields;
using measuring::number;
using measuring::numbers;
using measuring::rows;

namespace {

constexpr const char* map_name = "map";
constexpr std::size_t map_points = 64;  // along each axis

/// Columns of both tables.
namespace impacts {
enum Column : std::size_t { name, law, ratio, damping, start, end, final };
}
namespace map {
enum Column : std::size_t { ratio, start, end, periods, final = periods + 2 };
}

contact::Law law(const Fields& row, double stiffness) {
  const auto damping = static_cast<double>(number(row[impacts::damping]));
  if (row[impacts::law] == "linear") return contact::Linear{stiffness};
  if (row[impacts::law] == "hertz") return contact::Hertz{stiffness};
  return contact::Viscoelastic{.stiffness = stiffness, .damping = damping, .exponent = 1.5};
}

/// Equal balls touching; the first moves at unit speed, the last at `last`.
model::Chain touching(std::vector<contact::Law> laws, double last) {
  const std::size_t balls = laws.size() + 1;
  model::Chain chain{.mass = std::vector<double>(balls, 1.0),
                     .law = std::move(laws),
                     .gap = std::vector<double>(balls - 1, 0.0),
                     .velocity = std::vector<double>(balls, 0.0)};
  chain.velocity.back() = last;
  chain.velocity.front() = 1;
  return chain;
}

Case impact(const Fields& row) {
  auto velocity = numbers(row, impacts::final);
  std::vector<contact::Law> laws(velocity.size() - 1, law(row, 1));
  laws.back() = law(row, static_cast<double>(number(row[impacts::ratio])));
  return {.model = touching(std::move(laws), static_cast<double>(number(row[impacts::start]))),
          .velocity = std::move(velocity),
          .end = static_cast<double>(number(row[impacts::end]))};
}

Case map_point(const Fields& row) {
  const auto value = [&](std::size_t column) { return static_cast<double>(number(row[column])); };
  return {.model = touching({contact::Hertz{1}, contact::Hertz{value(map::ratio)}}, value(map::start)),
          .velocity = numbers(row, map::final),
          .end = value(map::end),
          .periods = {std::stoi(row[map::periods]), std::stoi(row[map::periods + 1])}};
}

Problem whole_map(std::size_t stride) {
  const auto table = rows(map_csv);
  Problem map{.name = map_name, .cases = {}};
  for (std::size_t i = 0; i < map_points; i += stride)
    for (std::size_t j = 0; j < map_points; j += stride)
      map.cases.push_back(map_point(table[i * map_points + j]));
  return map;
}

}  // namespace

std::vector<std::string> problem_names() {
  std::vector<std::string> names;
  for (const auto& row : rows(impacts_csv)) names.push_back(row[impacts::name]);
  for (const auto& row : rows(bodies_csv)) names.push_back(name_of_body(row));
  names.emplace_back(map_name);
  return names;
}

Problem problem(const std::string& name, std::size_t stride) {
  if (name == map_name) return whole_map(stride);
  for (const auto& row : rows(impacts_csv))
    if (row[impacts::name] == name) return {.name = name, .cases = {impact(row)}};
  for (const auto& row : rows(bodies_csv))
    if (name_of_body(row) == name) return {.name = name, .cases = {body_impact(row)}};
  throw InvalidParameter("unknown problem '" + name + "'");
}

}  // namespace mariotte::work_precision
