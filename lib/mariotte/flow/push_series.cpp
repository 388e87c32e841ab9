#include "mariotte/flow/push_series.hpp"

#include <cmath>

namespace mariotte::flow {
namespace {

/// The coefficients around another place.
void move(PushPolynomial& p, int order, double place) {
  for (int first = 0; first < order; ++first)
    for (int k = order - 1; k >= first; --k) p[k] += place * p[k + 1];
}

void set_root(const PushPolynomial& square, int order, PushPolynomial& root) {
  root[0] = std::sqrt(square[0]);
  for (int i = 1; i <= order; ++i) {
    double sum = square[i];
    for (int k = 1; k < i; ++k) sum -= root[k] * root[i - k];
    root[i] = sum / (2 * root[0]);
  }
}

}  // namespace

PushSeries part(const PushSeries& whole, double begin, double end) {
  PushSeries result = whole;
  result.end = end - begin;
  if (begin == 0) return result;
  if (!whole.is_time) move(result.pace, whole.order, begin);
  for (auto& c : result.contact) {
    move(c.depth, whole.order, begin);
    move(c.rate, whole.order, begin);
    if (c.owns_clock)
      c.root = result.pace;
    else if (c.is_curved)
      set_root(c.depth, whole.order, c.root);
  }
  return result;
}

}  // namespace mariotte::flow
