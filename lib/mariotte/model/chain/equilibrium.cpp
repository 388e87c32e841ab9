#include "mariotte/model/chain/equilibrium.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"

namespace mariotte::model {
namespace {

void expect_held(const Chain& chain, double precompression) {
  if (!(precompression >= 0) || !std::isfinite(precompression))
    throw InvalidParameter("the precompression must not be negative, and finite");
  const bool open = std::any_of(chain.gap.begin(), chain.gap.end(), [](double gap) { return gap > 0; });
  const bool walls = std::isinf(chain.mass.front()) && std::isinf(chain.mass.back());
  if (precompression > 0 && (open || !walls))
    throw InvalidParameter(open ? "a row with an open gap cannot be precompressed"
                                : "nothing holds the precompression: it needs walls at both ends");
}

/// Adds what the balls weigh, going down from the top: `ball(i)` and `contact(j)` count from there.
void add_weights(const Chain& chain, double gravity, auto&& ball, auto&& contact,
                 std::vector<double>& force) {
  const Index contacts = std::ssize(chain.law);
  double weight = 0;
  Index first = 0;  // contact under the highest ball that rests on what is below
  for (Index j = 0; j < contacts; ++j) {
    const double above = chain.mass[ball(j)];
    if (std::isinf(above)) {
      weight = 0;
      first = j;
    } else {
      weight += above * gravity;
    }
    force[contact(j)] += weight;
    if (!(chain.gap[contact(j)] > 0)) continue;
    for (Index k = first; k <= j; ++k) force[contact(k)] = 0;  // all of this falls
    weight = 0;
    first = j + 1;
  }
  if (std::isfinite(chain.mass[ball(contacts)]))
    for (Index k = first; k < contacts; ++k) force[contact(k)] = 0;
}

}  // namespace

std::vector<double> static_forces(const Chain& chain, double precompression) {
  validate(chain);
  expect_held(chain, precompression);
  const Index contacts = std::ssize(chain.law);
  std::vector<double> force(contacts, precompression);
  const auto from_right = [](Index last) { return [last](Index i) { return last - i; }; };
  const auto from_left = [](Index i) { return i; };
  if (chain.gravity > 0)
    add_weights(chain, chain.gravity, from_right(contacts), from_right(contacts - 1), force);
  if (chain.gravity < 0) add_weights(chain, -chain.gravity, from_left, from_left, force);
  return force;
}

void put_at_rest(Chain& chain, double precompression) {
  const auto force = static_forces(chain, precompression);
  for (std::size_t j = 0; j < force.size(); ++j)
    if (!(chain.gap[j] > 0))
      chain.gap[j] = force[j] > 0 ? -contact::static_indentation(chain.law[j], force[j]) : 0.0;
  chain.precompressed = true;
}

}  // namespace mariotte::model
