#include "mariotte/impact/sensitivity/adjoint/motion_recorder.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/core/error.hpp"

namespace mariotte::impact {

using flow::PushPolynomial;
using flow::PushSeries;

namespace {

constexpr int most_halvings = 10;

Nodes values(const PushPolynomial& p, int order, const Nodes& place) {
  Nodes sum;
  sum.fill(p[order]);
  for (int k = order - 1; k >= 0; --k)
    for (int i = 0; i < stages; ++i) sum[i] = sum[i] * place[i] + p[k];
  return sum;
}

/// Of the interpolant of a function, two coefficients among the highest.
double tail(const Nodes& function, int first) {
  double size = 0;
  for (const int n : {first, first + 1}) {
    double sum = 0;
    for (int i = 0; i < stages; ++i) sum += gauss.tail[n][i] * function[i];
    size += std::abs(sum);
  }
  return size;
}

/// Slopes of a force, by δ and δ̇, times dt/du.
struct Stiffness {
  Nodes by_depth, by_rate;
};

Stiffness stiffness_of(const contact::PowerLaw& law, const Nodes& depth, const Nodes& rate,
                       const Nodes& pace) {
  Stiffness made;
  for (int i = 0; i < stages; ++i) {
    const auto force = contact::smooth_force(law, depth[i], rate[i]);
    made.by_depth[i] = pace[i] * force.by_indentation;
    made.by_rate[i] = pace[i] * force.by_rate;
  }
  return made;
}

/// Whether the points resolve f ln δ, but for the logarithms of u and 1 − u, which are known.
bool resolves_logarithm(const contact::PowerLaw& law, const MotionRecord::Contact& own, const Nodes& rate,
                        const Nodes& pace, double mobility, double accuracy) {
  const auto [least, most] = std::minmax_element(own.depth.begin(), own.depth.end());
  if (law.exponent == 1 || *least > 0.1 * *most) return true;
  Nodes product;
  for (int i = 0; i < stages; ++i) {
    const double depth = std::max(own.depth[i], 1e-300), u = gauss.point[i],
                 left = gauss.point[stages - 1 - i];
    product[i] = mobility * pace[i] * contact::smooth_force(law, depth, rate[i]).value *
                 (std::log(depth) - own.rise * std::log(u) - own.fall * std::log(left));
  }
  return is_resolved(tail(product, 0), tail(product, 2), accuracy);
}

/// Whether the points resolve what a contact does, and sweeps converge: nothing moves by more than it is.
bool resolves(const Stiffness& contact, double mobility, double duration, double accuracy) {
  Nodes turned;
  for (int i = 0; i < stages; ++i)
    turned[i] = 0.5 * duration * std::abs(contact.by_depth[i]) + contact.by_rate[i];
  const double gain = mobility * duration;
  return mobility * total(turned) <= 1 &&
         is_resolved(gain * tail(contact.by_depth, 0), gain * tail(contact.by_depth, 2), accuracy);
}

}  // namespace

/// Where Gauss points stand in a series: polynomials of `argument`, times `unit`, and dt/du.
struct MotionRecorder::Places {
  bool are_first, are_last;
  Nodes argument, unit, pace;
};

/// Where contacts start from δ = 0 roots of u⁴ are smooth.
MotionRecorder::Places MotionRecorder::places(double begin, double width) const {
  Places at;
  at.are_first = begin == 0;
  at.are_last = begin + width == 1;
  for (int i = 0; i < stages; ++i) {
    const double u = begin + width * gauss.point[i], end = series_.end;
    const bool starts = series_.power > 0;
    at.unit[i] = starts ? end * u * u * u * u : 1;
    at.argument[i] = starts ? std::pow(at.unit[i], series_.power) : end * u;
    at.pace[i] = width * end * (starts ? 4 * u * u * u : 1);
  }
  if (series_.power > 0 || series_.is_time) return at;
  const auto clock = values(series_.pace, series_.order, at.argument);
  for (int i = 0; i < stages; ++i) at.pace[i] *= clock[i];
  return at;
}

void MotionRecorder::begin(const model::ChainSystem& slice, Index first, Instant start) {
  slice_ = &slice;
  done_ = {};
  missing_ = 0;
  end_ = 0;
  begin_part({.first = first, .last = first + slice.layout().contacts(), .begin = start});
  wanted_ = memory_.wanted(seen_.stretch.front());
}

void MotionRecorder::begin_part(const MotionRecord::Stretch& part) {
  seen_.stretch.assign(1, part);
  seen_.piece.clear();
  drop(0, 0);
  seen_.closing.clear();
}

/// The present part is over. Of all that are, only the last ones are kept.
void MotionRecorder::close_part() {
  auto& part = seen_.stretch.front();
  part.end = part.begin + end_;
  part.pieces = std::ssize(seen_.piece);
  part.contacts = std::ssize(seen_.contact);
  part.rates = std::ssize(seen_.rate);
  part.closings = std::ssize(seen_.closing);
  append(done_, seen_);
  if (2 * done_.bytes() <= memory_.most_bytes()) return;
  const Index count = std::ssize(done_.stretch), left_out = count / 2;
  done_ = part_of(done_, left_out, count);
  missing_ += left_out;
}

void MotionRecorder::next_part() {
  close_part();
  auto next = seen_.stretch.front();
  next.start = next.end;
  ++next.part;
  begin_part(next);
}

void MotionRecorder::observe(const flow::Step& step) {
  constexpr int most_parts = 8;
  watch_();
  if (!(step.end > step.start)) return;
  if (end_ == 0) note_closings(step.before);
  if (!step.series(series_))
    throw InvalidParameter(
        "slopes are computed backwards where series follow all of a row, which they do not");
  if (is_wanted() && most_parts * seen_.bytes() > memory_.most_bytes()) next_part();
  end_ = step.end;
  if (is_wanted()) add(step, 0, 1, 0);
}

void MotionRecorder::keep() {
  if (end_ > 0 && is_wanted()) close_part();
  if (!done_.stretch.empty()) memory_.add(missing_, done_);
}

/// A linear damped contact begins with the force c δ̇.
void MotionRecorder::note_closings(ConstState x) {
  const auto& layout = slice_->layout();
  for (Index j = 0; j < layout.contacts(); ++j) {
    const auto& contact = slice_->phase().flows().contact(j);
    const double rate = x[layout.velocity[j]] - x[layout.velocity[j + 1]];
    const bool begins =
        contact.role == flow::Role::closed && rate > 0 && -x[layout.gap[j]] <= 16 * epsilon * contact.length;
    if (begins && contact.exponent == 1 && contact.damping > 0)
      seen_.closing.push_back(seen_.stretch.front().first + j);
  }
}

Index MotionRecorder::number_of(Index gap) const {
  const auto& places = slice_->layout().gap;
  return seen_.stretch.front().first + (std::lower_bound(places.begin(), places.end(), gap) - places.begin());
}

void MotionRecorder::add_contact(const PushSeries::Contact& contact, const Places& places) {
  const Index j = number_of(contact.gap);
  auto depth = values(contact.depth, series_.order, places.argument);
  for (int i = 0; i < stages; ++i) depth[i] *= places.unit[i];
  const int power = contact.owns_clock ? 2 : 1;
  seen_.contact.push_back({.number = j,
                           .depth = depth,
                           .rise = places.are_first && contact.depth[0] == 0 ? power : 0,
                           .fall = places.are_last && ends(contact, depth) ? power : 0});
  if (law(j).damping > 0) seen_.rate.push_back(values(contact.rate, series_.order, places.argument));
}

/// δ comes to zero with the step.
bool MotionRecorder::ends(const PushSeries::Contact& contact, const Nodes& depth) const {
  constexpr double nothing = 1e-9;
  Nodes end;
  end.fill(series_.end);
  return series_.power == 0 && std::abs(values(contact.depth, series_.order, end)[0]) <
                                   nothing * *std::max_element(depth.begin(), depth.end());
}

void MotionRecorder::drop(std::size_t contacts, std::size_t rates) {
  seen_.contact.resize(contacts);
  seen_.rate.resize(rates);
}

/// Whether what a dozing contact does is so little that it counts to first order only.
bool MotionRecorder::is_shallow(const PushSeries::Contact& contact) const {
  const auto& power = law(number_of(contact.gap));
  return power.damping == 0 && power.exponent >= 1.5;
}

/// The contacts that have been added last.
bool MotionRecorder::are_resolved(const MotionRecord::Piece& piece) const {
  const auto& inverse_mass = slice_->chain().inverse_mass;
  auto rate = seen_.rate.end();
  for (auto own = seen_.contact.end(); own != seen_.contact.end() - piece.contacts;) {
    const Index j = (--own)->number - seen_.stretch.front().first;
    const auto& power = law(own->number);
    const Nodes rates = power.damping == 0 ? Nodes{} : *--rate;
    const double mobility = inverse_mass[j] + inverse_mass[j + 1];
    const auto stiffness = stiffness_of(power, own->depth, rates, piece.pace);
    if (!resolves(stiffness, mobility, total(piece.pace), accuracy_) ||
        !resolves_logarithm(power, *own, rates, piece.pace, mobility, accuracy_))
      return false;
  }
  return true;
}

/// Where a series starts from δ = 0 it says nothing of contacts so shallow that their force is left out.
void MotionRecorder::add_dozing(const flow::Step& step, const Places& places) {
  const auto& layout = slice_->layout();
  std::vector<double> x(layout.size);
  const auto first = seen_.contact.size();
  for (Index j = 0; j < layout.contacts(); ++j) {
    const auto is_own = [&](const auto& one) { return one.gap == layout.gap[j]; };
    const auto& all = series_.contact;
    const Index number = seen_.stretch.front().first + j;
    if (!slice_->phase().flows().contact(j).pushes() || std::any_of(all.begin(), all.end(), is_own)) continue;
    seen_.contact.push_back({.number = number, .depth = {}});
    if (law(number).damping > 0) seen_.rate.push_back({});
  }
  for (int i = 0; i < stages && first < seen_.contact.size(); ++i) {
    step.at(step.start + places.unit[i], x);
    for (auto own = seen_.contact.begin() + first; own != seen_.contact.end(); ++own)
      own->depth[i] = -x[layout.gap[own->number - seen_.stretch.front().first]];
  }
}

/// The step from `begin` on, `width` of it.
void MotionRecorder::add(const flow::Step& step, double begin, double width, int halvings) {
  const auto at = places(begin, width);
  MotionRecord::Piece piece{.pace = at.pace};
  const auto contacts = seen_.contact.size(), rates = seen_.rate.size();
  for (const auto& contact : series_.contact) add_contact(contact, at);
  for (const auto& contact : series_.dozing)
    if (!is_shallow(contact)) add_contact(contact, at);
  piece.contacts = static_cast<Index>(seen_.contact.size() - contacts);
  if (halvings < most_halvings && !are_resolved(piece)) {
    drop(contacts, rates);
    add(step, begin, width / 2, halvings + 1);
    return add(step, begin + width / 2, width / 2, halvings + 1);
  }
  for (const auto& contact : series_.dozing)
    if (is_shallow(contact)) add_contact(contact, at);
  if (series_.power > 0) add_dozing(step, at);
  piece.shallow = static_cast<Index>(seen_.contact.size() - contacts) - piece.contacts;
  piece.contacts += piece.shallow;
  seen_.piece.push_back(piece);
}

}  // namespace mariotte::impact
