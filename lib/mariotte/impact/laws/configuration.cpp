#include "mariotte/impact/laws/configuration.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"
#include "mariotte/model/representable.hpp"

namespace mariotte::impact {
namespace {

using Numbers = std::vector<double>;
using Vector = Eigen::VectorXd;

Index dofs(const Configuration& c) {
  return std::ssize(c.velocity);
}
Index contacts(const Configuration& c) {
  return std::ssize(c.contact);
}
bool is_diagonal(const Configuration& c) {
  return model::is_diagonal(c.mass, dofs(c));
}

Eigen::Map<const Vector> view(const Numbers& numbers) {
  return {numbers.data(), std::ssize(numbers)};
}
Eigen::Map<const Eigen::MatrixXd> full_mass(const Configuration& c) {
  return {c.mass.data(), dofs(c), dofs(c)};
}

void expect(bool holds, const char* rule) {
  if (!holds) throw InvalidParameter(rule);
}

/// Whether every mass at the largest speed has an energy that laws can compute with; rest has none.
bool energies_fit(const Configuration& c) {
  double speed = 0;
  for (const double v : c.velocity) speed = std::max(speed, std::abs(v));
  if (speed == 0) return true;
  const auto fits = [](double size) { return size >= model::smallest_size && size <= model::largest_size; };
  const Index stride = is_diagonal(c) ? 1 : dofs(c) + 1;
  for (Index i = 0; i < std::ssize(c.mass); i += stride)
    if (!std::isinf(c.mass[i]) &&
        (!fits(c.mass[i]) || !fits(speed * speed) || !fits(c.mass[i] * speed * speed)))
      return false;
  return true;
}

}  // namespace

Configuration chain_configuration(Numbers mass, Numbers velocity) {
  Configuration c{.mass = std::move(mass), .contact = {}, .velocity = std::move(velocity)};
  for (Index j = 0; j + 1 < dofs(c); ++j) c.contact.push_back({{j, -1}, {j + 1, 1}});
  return c;
}

void validate(const Configuration& c) {
  expect(dofs(c) > 0, "an impact needs at least one velocity");
  expect(contacts(c) > 0, "an impact needs at least one contact");
  for (const double v : c.velocity) expect(std::isfinite(v), "every velocity must be finite");
  model::validate(c.mass, c.contact, dofs(c));
  expect(energies_fit(c), "energies of this impact, m v², are too large or too small for double precision");
}

Numbers gap_rates(const Configuration& c, const Numbers& velocity) {
  Numbers rates;
  for (const auto& direction : c.contact) rates.push_back(gap_rate(direction, velocity));
  return rates;
}

Numbers generalised_impulse(const Configuration& c, const Numbers& p) {
  Numbers change(c.velocity.size(), 0.0);
  for (Index j = 0; j < contacts(c); ++j)
    for (const auto& [dof, coefficient] : c.contact[j]) change[dof] += coefficient * p[j];
  return change;
}

Numbers velocity_change(const Configuration& c, const Numbers& p) {
  return model::solve(c.mass, generalised_impulse(c, p));
}

double kinetic_energy(const Configuration& c, const Numbers& velocity) {
  if (!is_diagonal(c)) return 0.5 * view(velocity).dot(full_mass(c) * view(velocity));
  double sum = 0;
  for (Index i = 0; i < dofs(c); ++i)
    if (std::isfinite(c.mass[i])) sum += c.mass[i] * velocity[i] * velocity[i];
  return 0.5 * sum;
}

}  // namespace mariotte::impact
