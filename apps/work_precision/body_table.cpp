#include "body_table.hpp"

#include <algorithm>
#include <numbers>

namespace mariotte::work_precision {

using measuring::Fields;
using measuring::number;
using measuring::numbers;

namespace {

enum Column : std::size_t {
  name,
  shape,
  radius,
  length_ratio,
  damping_hertz,
  damping_adhesion,
  friction,
  angles,
  velocity = angles + 3,
  spin = velocity + 3,
  end = spin + 3,
  final
};

// Ammonium fluorescein on silicon [Cheng 2002, Table 1, corrected].
constexpr contact::Surface surface{.stiffness = 1.74e9, .adhesion = 0.38};
constexpr double density = 1350;

double value(const Fields& row, std::size_t column) {
  return static_cast<double>(number(row[column]));
}

Vector3 vector(const Fields& row, std::size_t column) {
  return {value(row, column), value(row, column + 1), value(row, column + 2)};
}

model::Microbody microbody(const Fields& row) {
  const double r = value(row, radius);
  const bool is_sphere = row[shape] == "sphere";
  model::Microbody body{
      .body = is_sphere ? model::sphere(r, density) : model::rod(r, value(row, length_ratio), density),
      .law = {},
      .friction = {value(row, friction)},
      .attitude = {},
      .velocity = vector(row, velocity),
      .spin = vector(row, spin)};
  const auto law = contact::brach_dunn(surface, r, value(row, damping_hertz), value(row, damping_adhesion));
  body.law.assign(body.body.tips.size(), law);
  const Vector3 turn = (std::numbers::pi / 180) * vector(row, angles);
  body.attitude = from_euler({turn.e1, turn.e2, turn.e3});
  return body;
}

}  // namespace

std::string name_of_body(const Fields& row) {
  return row[name];
}

Case body_impact(const Fields& row) {
  const auto stated = microbody(row);
  const auto scaled = model::dimensionless(stated);
  const long double speed = scaled.speed * scaled.scale.velocity;
  auto after = numbers(row, final);
  for (std::size_t i = 0; i < after.size(); ++i) after[i] *= (i < 3 ? 1 : reach(stated.body)) / speed;
  return {.model = Body{stated, scaled}, .velocity = after, .end = value(row, end) / scaled.scale.time};
}

}  // namespace mariotte::work_precision
