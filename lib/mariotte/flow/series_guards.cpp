#include "mariotte/flow/series_guards.hpp"

#include <array>

namespace mariotte::flow {
namespace {

/// A guard over one step: terms c[k] endᵏ, which is its polynomial over [0, 1].
struct Terms {
  std::array<double, 32> at;
  std::size_t count;
  double moves;  ///< how far it goes, at most
  double end;    ///< where it comes to

  /// Even and odd powers apart, so that neither waits for the other.
  Terms(const GuardSeries& series, double place) : count(series.row.size()) {
    const double square = place * place;
    double odd = series.sign * place, even = series.sign * square, sum[2] = {}, size[2] = {};
    const auto add = [&](std::size_t k, double power) {
      at[k] = series.row[k] * power;
      sum[k % 2] += at[k];
      size[k % 2] += std::abs(at[k]);
    };
    at[0] = series.sign * (series.row[0] + series.offset);
    for (std::size_t k = 1; k + 1 < count; k += 2, odd *= square, even *= square) {
      add(k, odd);
      add(k + 1, even);
    }
    if (count % 2 == 0) add(count - 1, odd);
    moves = size[0] + size[1];
    end = at[0] + (sum[0] + sum[1]);
  }
  /// What takes away from it is too little to bring it to zero.
  bool stays_above() const {
    constexpr double rounding = 1e-14;
    return at[0] - 0.5 * (moves - (end - at[0])) > rounding * moves;
  }
  std::span<const double> all() const { return {at.data(), count}; }
  /// Bound of what the series leaves out at the end.
  double tail() const { return std::abs(at[count - 1]) + std::abs(at[count - 2]); }
};

/// Whether what its series leaves out could hide the fall of a guard that ends above zero.
bool may_hide_fall(const Terms& terms) {
  return terms.tail() > 1e-12 * terms.moves && std::abs(terms.end) < 100 * terms.tail();
}

/// Whether it could move the root at which a step ends.
bool may_move_root(const Terms& terms) {
  return terms.tail() > 1e-3 * terms.moves;
}

/// Whether the first terms keep a guard above zero at a share of the step, more than the others do.
bool leads(const Terms& terms, std::size_t first, double share) {
  const auto all = terms.all();
  return horner(all.first(first), share) > std::abs(horner(all, share) - horner(all.first(first), share));
}

/// First share of the step at which a guard falls through zero. One that starts behind zero is measured from
/// there, unless it goes on falling. Leading terms that are smaller than `rounding` of its change are zero,
/// unless it falls from above: the noise that it is allowed then tells which way it went. They are not zero
/// either where they are what keeps it above.
std::optional<double> fall(const Terms& terms, double rounding) {
  const auto& c = terms.at;
  std::size_t k = 0;
  const auto is_zero = [&] { return std::abs(c[k]) <= rounding * terms.moves || (k == 0 && c[0] < 0); };
  while (k + 1 < terms.count && is_zero()) ++k;
  if (k > 0 && c[k] < 0 && !(c[0] > 0)) return 0.0;
  if (c[k] < 0) return first_fall(terms.all(), 1);
  const auto share = first_fall(terms.all().subspan(k), 1);
  return share && k > 0 && leads(terms, k, 0.5 * *share) ? first_fall(terms.all(), 1) : share;
}

/// Steps end a little earlier where a guard is in doubt, and so the next one tells.
constexpr double shortened = 0.7;
/// A guard that is farther above zero than it goes, by this factor, is not near it.
constexpr double far = 1.01;

}  // namespace

void look(Index guard, const GuardSeries& series, double rounding, SeriesEnd& end) {
  for (;;) {
    const Terms terms(series, end.place);
    if (!(terms.moves > 0) || terms.at[0] > far * terms.moves) return;
    const auto share = terms.stays_above() ? std::nullopt : fall(terms, rounding);
    const double place = share ? *share * end.place : end.place;
    const bool doubtful = !share ? may_hide_fall(terms) : *share > 0 && may_move_root({series, place});
    if (share && !doubtful) end = {place, guard};
    if (!doubtful) return;
    end = {shortened * place};
  }
}

double most_change(std::span<const double> row, double place) {
  double sum = 0;
  for (std::size_t k = row.size(); k-- > 1;) sum = sum * place + std::abs(row[k]);
  return sum * place;
}

}  // namespace mariotte::flow
