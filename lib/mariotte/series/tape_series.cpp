#include "mariotte/series/tape_series.hpp"

#include <algorithm>
#include <cmath>

namespace mariotte::series {
namespace {

/// Σ a_j b_{k−j} over first ≤ j ≤ last.
double convolve(const double* a, const double* b, int k, int first, int last) {
  double even = 0, odd = 0;
  int j = first;
  for (; j + 1 <= last; j += 2) {
    even += a[j] * b[k - j];
    odd += a[j + 1] * b[k - j - 1];
  }
  if (j <= last) even += a[j] * b[k - j];
  return even + odd;
}

/// Σ a_j a_{k−j} over all j.
double square(const double* a, int k) {
  double sum = 0;
  for (int j = 0; 2 * j < k; ++j) sum += a[j] * a[k - j];
  return 2 * sum + (k % 2 == 0 ? a[k / 2] * a[k / 2] : 0);
}

/// Σ j a_j b_{k−j}/k: what sines and cosines are made of.
double slope_product(const double* a, const double* b, int k) {
  double sum = 0;
  for (int j = 1; j <= k; ++j) sum += j * a[j] * b[k - j];
  return sum / k;
}

/// w with w⁴ − w = a, and its square.
void width(const double* a, int k, double* w, double* square) {
  if (k == 0) {
    w[0] = WidthCurve{.radius = 1, .s = 1}.root(a[0]);
    square[0] = w[0] * w[0];
    return;
  }
  const double known = convolve(w, w, k, 1, k - 1);
  const double rest = convolve(square, square, k, 1, k - 1) + 2 * square[0] * known;
  w[k] = (a[k] - rest) / (4 * w[0] * square[0] - 1);
  square[k] = known + 2 * w[0] * w[k];
}

int leading_zeros(const double* a, int order) {
  int k = 0;
  while (k < order && a[k] == 0) ++k;
  return k;
}

bool is_input(TapeOp op) {
  return op == TapeOp::constant || op == TapeOp::state;
}

/// Marks all that the marked places need.
void spread(const Tape& tape, std::vector<char>& need) {
  for (Index i = tape.size(); i-- > 0;) {
    if (!need[i]) continue;
    const auto& node = tape[i];
    if (is_input(node.op)) continue;
    need[node.a] = 1;
    if (node.b >= 0) need[node.b] = 1;
    if (node.op == TapeOp::sine || node.op == TapeOp::width) need[i + 1] = 1;
    if (node.op == TapeOp::cosine) need[i - 1] = 1;
  }
}

std::vector<int> marked(const Tape& tape, const std::vector<char>& need, const std::vector<char>* known) {
  std::vector<int> list;
  for (Index i = 0; i < tape.size(); ++i)
    if (need[i] && !is_input(tape[i].op) && !(known && (*known)[i])) list.push_back(static_cast<int>(i));
  return list;
}

}  // namespace

void TapeSeries::prepare(const Tape& tape, std::span<TapeState> state, std::span<const int> clocks,
                         std::span<const int> seen) {
  tape_ = &tape;
  state_ = state;
  rows_.assign(tape.size() * stride, 0.0);
  lag_.assign(tape.size(), 0);
  for (Index i = 0; i < tape.size(); ++i)
    if (tape[i].op == TapeOp::constant) at(static_cast<int>(i))[0] = tape[i].number;
  // What no rate and no guard depends on is an integral; the rest feeds.
  need_.assign(tape.size(), 0);
  for (const auto& one : state) need_[one.rate] = 1;
  for (const auto& places : {clocks, seen})
    for (const int place : places) need_[place] = 1;
  auto all = need_;
  spread(tape, all);
  std::fill(need_.begin(), need_.end(), 0);
  for (auto& one : state) {
    one.feeds = all[one.place];
    if (one.feeds) need_[one.rate] = 1;
  }
  for (const int place : clocks) need_[place] = 1;
  spread(tape, need_);
  feeding_ = marked(tape, need_, nullptr);
  seen_ = marked(tape, all, &need_);
}

void TapeSeries::start(std::span<const double> x, const TapeClock& clock) {
  clock_ = clock;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    std::fill_n(at(state_[i].place), stride, 0.0);
    at(state_[i].place)[0] = x[i];
  }
  std::fill_n(time_, stride, 0.0);
  const bool onset = clock.kind == TapeClock::Kind::onset;
  for (const int i : feeding_) {
    const auto& node = (*tape_)[i];
    lag_[i] = std::max(lag_[node.a], node.b >= 0 ? lag_[node.b] : 0);
    if (onset && node.op == TapeOp::root && (*tape_)[node.a].op == TapeOp::onset) lag_[i] = 1;
    if (onset) std::fill_n(at(i), stride, 0.0);
  }
}

/// √δ where δ = d₂τ² + …: its coefficient k needs that of δ one order later.
void TapeSeries::onset_root(const TapeNode& node, int place, int k) {
  const double* a = at(node.a);
  double* r = at(place);
  if (k == 0)
    r[0] = 0;
  else if (k == 1)
    r[1] = std::sqrt(a[2]);
  else
    r[k] = (a[k + 1] - convolve(r, r, k + 1, 2, k - 1)) / (2 * r[1]);
}

void TapeSeries::coefficient(const TapeNode& node, int place, int k) {
  double* c = at(place);
  const double* a = at(node.a);
  const double* b = node.b >= 0 ? at(node.b) : nullptr;
  switch (node.op) {
    case TapeOp::sum:
      c[k] = a[k] + b[k];
      return;
    case TapeOp::difference:
      c[k] = a[k] - b[k];
      return;
    case TapeOp::offset:
      c[k] = a[k] + (k == 0 ? node.number : 0);
      return;
    case TapeOp::scaled:
      c[k] = node.number * a[k];
      return;
    case TapeOp::product:
      c[k] = a == b ? square(a, k) : convolve(a, b, k, 0, k);
      return;
    case TapeOp::quotient:
      c[k] = (a[k] - convolve(b, c, k, 1, k)) / b[0];
      return;
    case TapeOp::root:
      c[k] = k == 0 ? std::sqrt(a[0]) : (a[k] - convolve(c, c, k, 1, k - 1)) / (2 * c[0]);
      return;
    case TapeOp::sine: {
      double* cosine = at(place + 1);
      c[k] = k == 0 ? std::sin(a[0]) : slope_product(a, cosine, k);
      cosine[k] = k == 0 ? std::cos(a[0]) : -slope_product(a, c, k);
      return;
    }
    case TapeOp::width:
      return width(a, k, c, at(place + 1));
    case TapeOp::onset:
      c[k] = k == 0 && clock_.kind == TapeClock::Kind::onset ? 0 : a[k];
      return;
    case TapeOp::cosine:
    case TapeOp::square_of_width:
    case TapeOp::constant:
    case TapeOp::state:
      return;
  }
}

/// Coefficient k of a rate times dt/d(clock).
double TapeSeries::rate(int place, int k) const {
  const double* r = &rows_[place * stride];
  switch (clock_.kind) {
    case TapeClock::Kind::time:
      return r[k];
    case TapeClock::Kind::onset:
      return k > 0 ? 2 * r[k - 1] : 0;
    case TapeClock::Kind::root:
      return (*tape_)[place].op == TapeOp::constant ? r[0] * rows_[clock_.root * stride + k]
                                                    : convolve(r, &rows_[clock_.root * stride], k, 0, k);
  }
  return 0;
}

void TapeSeries::advance(const TapeState& one, int k) {
  at(one.place)[k + 1] = rate(one.rate, k) / (k + 1);
}

void TapeSeries::expand(std::span<const double> x, int order, const TapeClock& clock) {
  order_ = order;
  start(x, clock);
  const bool onset = clock.kind == TapeClock::Kind::onset;
  for (int k = 0; k <= order; ++k) {
    for (const int i : feeding_) {
      const auto& node = (*tape_)[i];
      const int late = k - lag_[i];
      if (late < 0) continue;
      if (onset && node.op == TapeOp::root && (*tape_)[node.a].op == TapeOp::onset)
        onset_root(node, i, late);
      else
        coefficient(node, i, late);
    }
    if (k == order) break;
    for (const auto& one : state_)
      if (one.feeds) advance(one, k);
  }
  for (int k = 0; k < order; ++k)
    time_[k + 1] = clock.kind == TapeClock::Kind::time    ? (k == 0 ? 1 : 0)
                   : clock.kind == TapeClock::Kind::onset ? (k == 1 ? 1 : 0)
                                                          : at(clock.root)[k] / (k + 1);
  see();
  for (const auto& one : state_)
    if (!one.feeds)
      for (int k = 0; k < order; ++k) advance(one, k);
}

/// Of series that both begin with zeros; a pole is no number.
void TapeSeries::late_quotient(const TapeNode& node, int place) {
  const double *a = at(node.a), *b = at(node.b);
  double* c = at(place);
  const int zeros = leading_zeros(b, order_);
  std::fill_n(c, stride, leading_zeros(a, order_) < zeros ? NAN : 0.0);
  if (std::isnan(c[0])) return;
  for (int k = 0; k + zeros <= order_; ++k)
    c[k] = (a[k + zeros] - convolve(b + zeros, c, k, 1, k)) / b[zeros];
}

/// Of a series that begins with an even number of zeros.
void TapeSeries::late_root(const TapeNode& node, int place) {
  const double* a = at(node.a);
  double* c = at(place);
  const int half = leading_zeros(a, order_) / 2;
  std::fill_n(c, stride, 0.0);
  if (half > 0 && 2 * half >= order_) return;
  double* r = c + half;
  r[0] = std::sqrt(a[2 * half]);
  for (int k = 1; k + 2 * half <= order_; ++k)
    r[k] = (a[k + 2 * half] - convolve(r, r, k, 1, k - 1)) / (2 * r[0]);
}

/// What guards and integrals need, once all that moves is known.
void TapeSeries::see() {
  for (const int i : seen_) {
    const auto& node = (*tape_)[i];
    if (node.op == TapeOp::quotient && at(node.b)[0] == 0)
      late_quotient(node, i);
    else if (node.op == TapeOp::root && at(node.a)[0] == 0)
      late_root(node, i);
    else
      for (int k = 0; k <= order_; ++k) coefficient(node, i, k);
  }
}

}  // namespace mariotte::series
