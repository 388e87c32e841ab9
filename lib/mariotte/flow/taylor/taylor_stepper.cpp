#include "mariotte/flow/taylor/taylor_stepper.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/roots/rough_root.hpp"
#include "mariotte/flow/series_guards.hpp"
#include "mariotte/flow/taylor/drive_series.hpp"
#include "mariotte/flow/taylor/felt.hpp"

namespace mariotte::flow::taylor {

namespace {

/// Share of the accuracy that one step may spend: errors add up along a chain, and behind its wave they must
/// not look like approaches.
constexpr double local_share = 0.03;
/// The short steps that one contact needs are steps of many others.
bool shares_steps(const Window& window) {
  return window.network && window.lanes.count > 5;
}
/// A contact that would let go within this share of a step is landed in its own clock. Earlier is dearer:
/// near its end a contact is so weak that it hardly bounds the step, among many less than among few, and
/// least in a longer row, where one lets go after the other. Measured by work_precision, scaling_study and
/// stiffness_study.
double landing_share(const Window& window) {
  if (shares_steps(window)) return 1;
  if (window.row && window.row->is_slice) return 0.15;
  return window.lanes.count > 5 ? 0.2 : 0.5;
}
/// Share of the stride that is left where steps get short all at once: they may do so for that contact alone.
constexpr double kept_stride = 0.75;
/// Of contacts whose roots bound the step more.
constexpr double share_of_strong_roots = 1.7;
/// Share of the radius of convergence that a step may use.
constexpr double safe_radius = 0.7;
/// How many times the tolerance the two terms before the last two may be. Where coefficients fall evenly they
/// are less, so this bounds a step only where the last two are small by chance.
constexpr double before_last = 300;
/// How much longer than the one before a step may be in which nothing pushes. Guards have less exact roots
/// the longer a step is.
constexpr double freed_stride = 8;
constexpr double tiny = 1e-300;  ///< keeps quotients of vanishing coefficients finite

/// Up to which no coefficient overflows: where a contact has hardly begun, they grow like (δ̇/δ)ᵏ.
int harmless_order(const Window& window, int order) {
  constexpr double decades = 270;
  const auto& l = window.lanes;
  double fastest = 1;
  for (int j = 0; j < l.count; ++j)
    if (l.active[j] > 0 && l.indentation[j] > 0 && window.is_sharp(j))
      fastest = std::max(fastest, std::abs(l.rate[j]) / l.indentation[j]);
  return std::min(order, static_cast<int>(decades / std::log10(fastest)));
}

/// At most: the change of the rate of a depth by its own force, if that was there since the depth was zero.
double given_since_onset(const Lanes& l, int j) {
  const double depth = l.indentation[j], rate = std::abs(l.rate[j]), root = std::pow(depth, l.power[j]);
  const double load = (l.stiffness[j] + l.steepening[j] * root) * depth +
                      (l.damping[j] + l.stiffening[j] * depth) * rate + l.ring[j];
  return (l.left[j] + l.right[j]) * root * load * depth / rate;
}

}  // namespace

/// Higher orders pay for themselves at tighter tolerances; measured by work_precision.
Precision precision(double accuracy) {
  Precision p{.tolerance = std::max(local_share * accuracy, 0.25 * epsilon), .order = order_limit};
  for (const auto& [above, order] : {std::pair{1e-5, 10}, {1e-7, 12}, {1e-9, 14}, {1e-11, 16}, {1e-13, 18}}) {
    if (!(accuracy > above)) continue;
    p.order = order;
    break;
  }
  return p;
}

void Stepper::begin(const Problem& problem, State x, double time, const Precision& precision) {
  precision_ = precision;
  last_clock_ = Expansion::plain;
  place(window, problem, x, time);
  values_.resize(window.lanes.count);
  const auto size = size_for(window.lanes);
  auto& chosen = expansions_[size];
  if (!chosen) chosen = make_expansion(size);
  series_ = chosen.get();
}

void Stepper::shorten(Piece& piece, double place) {
  piece.lands = piece.lands && place == piece.end;
  piece.is_cut = piece.is_cut && place == piece.end;
  piece.end = place;
  piece.evaluate(place, values_);
}

bool Stepper::is_struck(int lane) const {
  return window.contact(lane).role == Role::closed && window.lanes.indentation[lane] == 0 &&
         window.lanes.rate[lane] > 0;
}

/// The start series serves if all contacts that carry force are undamped Hertz contacts which start
/// undeformed, and some do so together.
bool Stepper::starts() {
  const auto& l = window.lanes;
  if (l.damped || l.general || window.drives) return false;
  parts_.assign(l.count, Start::Part::passive);
  if (!finds_struck() || !finds_pressed()) return false;
  const auto is_passive = [](Start::Part part) { return part == Start::Part::passive; };
  return l.count - std::count_if(parts_.begin(), parts_.end(), is_passive) > 1;
}

/// False if none is, or if there are contacts that the start series cannot follow.
bool Stepper::finds_struck() {
  const auto& l = window.lanes;
  bool any = false;
  for (int j = 0; j < l.count; ++j) {
    if (l.drive[j] != 0) return false;
    const auto& c = window.contact(j);
    if (c.role == Role::open) continue;
    if (l.indentation[j] != 0 || !window.is_sharp(j) || c.branch_guard >= 0) return false;
    if (!is_struck(j)) continue;
    parts_[j] = Start::Part::struck;
    any = true;
  }
  return any;
}

/// False if what touches a struck contact is drawn apart by it.
bool Stepper::finds_pressed() {
  const auto& l = window.lanes;
  for (int j = 0; j < l.count; ++j) {
    if (window.contact(j).role != Role::touching || l.rate[j] != 0) continue;
    bool drawn = false;
    for_each_felt(l, j, [&](int other, double weight) {
      if (parts_[other] != Start::Part::struck) return;
      parts_[j] = Start::Part::pressed;
      drawn |= weight < 0;
    });
    if (drawn) return false;
  }
  return true;
}

std::optional<Piece> Stepper::start_piece() {
  if (!starts()) return std::nullopt;
  auto& l = window.lanes;
  for (int j = 0; j < l.count; ++j) l.active[j] = parts_[j] != Start::Part::passive;
  Piece piece{.start = &start_, .order = precision_.order};
  double end = 0.9 * start_.expand(l, parts_.data(), precision_.order, precision_.tolerance);
  for (int tries = 0; tries < 60; ++tries, end *= 0.5) {
    shorten(piece, end);
    if (std::all_of(values_.margin, values_.margin + l.count, [](double margin) { return margin >= 0; }))
      return piece;
  }
  return std::nullopt;
}

/// The root of a contact counts at its onset, too: a damper's force begins as √t, and slopes do.
bool Stepper::has_strong_roots() const {
  return precision_.has_slopes || window.lanes.damped;
}

/// A contact that leaves its onset counts, too, as long as the clock is its own.
bool Stepper::counts_onsets() const {
  return last_clock_ != Expansion::plain && (has_strong_roots() || shares_steps(window));
}

/// The lane whose onset or end, less than the time `near` away, limits a series in time most.
int Stepper::choose_clock(double near) const {
  const auto& l = window.lanes;
  int clock = Expansion::plain;
  for (int j = 0; j < l.count; ++j) {
    const double depth = l.indentation[j], speed = std::abs(l.rate[j]);
    if (!(depth < near * speed) || !window.has_root(j)) continue;
    if (depth == 0 && l.rate[j] > 0) return j;  // it is struck
    const bool counts = l.rate[j] < 0 || (j == last_clock_ && counts_onsets());
    if (!counts || depth <= l.acts_above[j]) continue;
    near = depth / speed;
    clock = j;
  }
  return clock;
}

/// Which contacts carry force, and order and clock of the next series.
Piece Stepper::plan_piece() {
  auto& l = window.lanes;
  Piece piece{.series = series_, .order = precision_.order};
  const double near = (has_strong_roots() ? share_of_strong_roots : landing_share(window)) * stride;
  const auto outlook = series_->activate(l, near, counts_onsets());
  if (outlook.is_sudden) piece.order = harmless_order(window, piece.order);
  if (l.general || window.drives) return piece;
  if (l.widened)
    piece.clock = narrowest();
  else if (outlook.may_land)
    piece.clock = choose_clock(near);
  if (piece.clock != Expansion::plain && window.pushes(piece.clock)) l.active[piece.clock] = 1;
  return piece;
}

/// The lane whose contact is nearest to its smallest radius: of the points that no series in time passes, its
/// end is the nearest, and an ordinary one in its clock.
int Stepper::narrowest() const {
  const auto& l = window.lanes;
  int found = Expansion::plain;
  double least = infinity;
  for (int j = 0; j < l.count; ++j) {
    if (!l.branch[j]) continue;
    const double share = l.width[j] / l.branch[j]->curve.last();
    if (share < least) least = share, found = j;
  }
  return found;
}

/// Where the last coefficients come to the tolerance, but no further than a safe share of the radius of
/// convergence: beyond, a weak singularity, a contact about to let go, hides behind small coefficients. From
/// a turn on a motion has every second coefficient only: the last ones of δ and δ̇ are one number, which may
/// be small by chance. So the two before are looked at, too. Where either vanish, the others are rounding,
/// and say nothing.
double Stepper::reach(const Piece& piece) const {
  const bool fresh = piece.clock != Expansion::plain && window.lanes.rate[piece.clock] > 0;
  const int group = fresh ? 5 : 2;  // near an onset four of five vanish, or nearly so
  const int first = piece.order - 2 * group + 1;
  double end = infinity, last = 0, before = 0, size[10];
  piece.series->sizes(first, size);
  const auto bound = [&](int i, double most) {
    end = std::min(end, rough_root(most / std::max(size[i], tiny), first + i));
  };
  for (int i = 0; i < group; ++i) {
    bound(group + i, precision_.tolerance);
    if (!fresh) bound(i, before_last * precision_.tolerance);
    last = std::max(last, size[group + i]);
    before = std::max(before, size[i]);
  }
  if (!(std::min(last, before) > tiny))
    end = std::min(end, freed_stride * stride);
  else
    end = std::min(end, safe_radius * rough_root(before / last, group));
  return within_roots(piece, end);
}

/// Roots end where depths do, but for depths that are even powers of the clock since an onset: theirs end in
/// rounding alone, which grows from order to order as if they ended where the tangent of the depth does. What
/// it makes of a force is second order in rounding, and may vanish from the last orders by chance: so it is
/// bounded by what the force has given since the onset. It does no harm within some of these distances.
double Stepper::within_roots(const Piece& piece, double end) const {
  constexpr double harmless = 4, lost = 256 * epsilon * epsilon;
  const auto& l = window.lanes;
  const double pace = piece.clock == Expansion::plain ? 1 : 0.5 * std::sqrt(l.indentation[piece.clock]);
  for (int j = 0; !l.widened && j < l.count; ++j) {
    const double depth = l.indentation[j], rate = std::abs(l.rate[j]);
    const bool is_far = end * pace * rate > harmless * depth;
    if (!is_far || !(depth > 0 && l.active[j] > 0) || !window.is_sharp(j) || j == piece.clock) continue;
    const double share = precision_.tolerance / (lost * std::max(given_since_onset(l, j), tiny));
    const double distances = std::max(harmless, rough_root(std::min(share, 1 / tiny), piece.order));
    end = std::min(end, distances * depth / (rate * pace));
  }
  return end;
}

Piece Stepper::series_piece() {
  auto& l = window.lanes;
  auto piece = plan_piece();
  for (int j = 0; window.is_linked() && j < l.count; ++j) doze(j);
  for (int j = 0; l.general && j < l.count; ++j) listen(j);
  if (window.drives) expand_drives(window, piece.order);
  piece.series->expand(l, piece.order, piece.clock);
  if (window.drives) find_works(window, *piece.series, piece.order);
  piece.end = std::min(reach(piece), reach_of_drives(window, piece.order, precision_.tolerance));
  for (int j = 0; window.drives && j < l.count; ++j) end_beyond_noise(piece, j);
  for (int j = 0; l.segmented && j < l.count; ++j) end_beyond_knots(piece, j);
  if (piece.clock != Expansion::plain) land(piece);
  shorten(piece, piece.end);
  return piece;
}

/// A drive may press what touches at rest, and draw it apart again, within a step. End it where such a
/// contact has left the noise on either side, from where on it is watched.
void Stepper::end_beyond_noise(Piece& piece, int lane) const {
  const auto& l = window.lanes;
  const double level = 1.5 * l.leaves_noise[lane];
  if (!(std::abs(l.indentation[lane]) < level && level < infinity)) return;
  Coefficients c;
  const auto used = piece.coefficients(Quantity::indentation, lane, c);
  for (const double side : {-1.0, 1.0}) {
    Coefficients left;
    for (int k = 0; k <= piece.order; ++k) left[k] = side * c[k];
    left[0] += level;
    piece.end = std::min(piece.end, flow::place_of_fall(std::span(left).first(used.size()), piece.end));
  }
}

/// End it where a force has come to its next segment, or back to the one before: so far beyond their knot
/// that rounding leaves no doubt of the side. What both segments say there differs by less than rounding.
void Stepper::end_beyond_knots(Piece& piece, int lane) const {
  const auto* own = window.segment[lane];
  if (!own) return;
  const double length = window.contact(lane).length,
               beyond = 64 * epsilon * std::max(length, std::abs(window.lanes.indentation[lane]));
  Coefficients c;
  const auto used = piece.coefficients(Quantity::indentation, lane, c);
  const auto end_at_fall = [&](double side, double left) {
    if (left > most_change(used, piece.end)) return;
    Coefficients distance;
    for (int k = 1; k <= piece.order; ++k) distance[k] = side * c[k];
    distance[0] = left;
    piece.end = std::min(piece.end, flow::place_of_fall(std::span(distance).first(used.size()), piece.end));
  };
  end_at_fall(-1, own->to + beyond - c[0]);
  if (own->from < own->to) end_at_fall(1, c[0] - own->from + beyond);
}

/// End a piece in a contact's own clock where that contact lets go: behind, time would run backwards. There
/// δ is zero, which the landing tells better than δ itself.
void Stepper::land(Piece& piece) {
  auto& l = window.lanes;
  l.side[piece.clock] = 0;
  Coefficients c;
  const auto place = flow::first_fall(piece.coefficients(Quantity::clock, piece.clock, c), piece.end);
  piece.lands = place.has_value();
  piece.end = place.value_or(piece.end);
}

Piece Stepper::next(bool first, double time) {
  auto start = first ? start_piece() : std::nullopt;
  Piece piece = start ? *start : series_piece();
  if (first && window.drives)  // who looks for turns learns where what rests is driven to
    shorten(piece, std::min(piece.end, stride));
  if (!(values_.time < time)) {
    shorten(piece, piece.place(time, values_.time));
    values_.time = time;
    piece.is_cut = true;
  }
  wake_gently(piece);
  return piece;
}

void Stepper::advance(const Piece& piece) {
  stride = std::max(values_.time, kept_stride * stride);
  last_clock_ = piece.clock;
  taylor::advance(window, values_);
  if (piece.clock != Expansion::plain) watch(window, piece.clock);
}

}  // namespace mariotte::flow::taylor
