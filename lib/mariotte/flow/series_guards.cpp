#include "mariotte/flow/series_guards.hpp"

#include <array>

namespace mariotte::flow {
namespace {

constexpr std::size_t most_terms = 32;

/// Bound of what the series of a guard leaves out at a place.
double tail(std::span<const double> row, double place) {
  const std::size_t last = row.size() - 1;
  return (std::abs(row[last]) * place + std::abs(row[last - 1])) *
         std::pow(place, static_cast<double>(last - 1));
}

/// How far a guard moves until a place, by its terms.
double change(std::span<const double> row, double place) {
  double sum = 0, power = place;
  for (std::size_t k = 1; k < row.size(); ++k, power *= place) sum += std::abs(row[k]) * power;
  return sum;
}

/// Whether what its series leaves out could hide the fall of a guard that ends above zero, or move its root.
bool is_doubtful(std::span<const double> row, std::optional<double> fired, double end) {
  const double moves = change(row, end);
  if (!(moves > 0) || fired == 0.0) return false;
  if (fired) return tail(row, *fired) > 1e-3 * change(row, *fired);
  return tail(row, end) > 1e-12 * moves && std::abs(horner(row, end)) < 100 * tail(row, end);
}

/// First place at which a guard falls through zero. One that starts behind zero is measured from there,
/// unless it goes on falling. Leading terms that are smaller than `rounding` of its change are zero, unless
/// it falls from above: the noise that it is allowed then tells which way it went.
std::optional<double> fall(std::span<const double> row, double sign, double end, double rounding) {
  std::array<double, most_terms> c, term;
  double power = 1;
  for (std::size_t k = 0; k < row.size(); ++k, power *= end) {
    c[k] = sign * row[k];
    term[k] = std::abs(c[k] * power);
  }
  const double moves = change(row, end);
  if (!(moves > 0)) return std::nullopt;
  std::size_t k = 0;
  const auto is_zero = [&] { return term[k] <= rounding * moves || (k == 0 && c[0] < 0); };
  for (; k + 1 < row.size() && is_zero(); ++k) c[k] = 0;
  if (k > 0 && c[k] < 0) {
    if (!(sign * row[0] > 0)) return 0.0;
    for (std::size_t i = 0; i < k; ++i) c[i] = sign * row[i];
  }
  return first_fall({c.data(), row.size()}, end);
}

/// Whether a guard is so far above zero that its terms cannot bring it there.
bool is_far(std::span<const double> row, double sign, double end) {
  constexpr double margin = 1.01;
  return sign * row[0] > margin * change(row, end);
}

/// Steps end a little earlier where a guard is in doubt, and so the next one tells.
constexpr double shortened = 0.7;

}  // namespace

void look(Index guard, std::span<const double> row, double sign, double rounding, SeriesEnd& end) {
  if (is_far(row, sign, end.place)) return;
  auto fired = fall(row, sign, end.place, rounding);
  while (is_doubtful(row, fired, end.place)) {
    end = {shortened * fired.value_or(end.place)};
    fired = fall(row, sign, end.place, rounding);
  }
  if (fired) end = {*fired, guard};
}

}  // namespace mariotte::flow
