#include "mariotte/flow/taylor/taylor_stepper.hpp"

#include <algorithm>
#include <cmath>

#include "mariotte/flow/roots/polynomial.hpp"
#include "mariotte/flow/roots/rough_root.hpp"
#include "mariotte/flow/taylor/felt.hpp"

namespace mariotte::flow::taylor {

namespace {

/// Share of the accuracy that one step may spend: errors add up along a chain, and behind its wave they must
/// not look like approaches.
constexpr double local_share = 0.03;
/// A contact that would let go within this share of a step is landed in its own clock. Earlier is dearer:
/// near its end a contact is so weak that it hardly bounds the step, among many less than among few, and
/// least in a longer row, where one lets go after the other. Measured by work_precision and scaling_study.
double landing_share(const Window& window) {
  if (window.row && window.row->is_slice) return 0.15;
  return window.lanes.count > 8 ? 0.2 : 0.5;
}
/// A contact may sink this far past the depth at which it wakes before it is heard.
constexpr double late = 5;
/// Share of that depth at which a step ends that would go further.
constexpr double in_time = 0.6;

/// Share of the radius of convergence that a step may use.
constexpr double safe_radius = 0.7;
constexpr double tiny = 1e-300;  ///< keeps quotients of vanishing coefficients finite

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
  if (const auto* row = problem.serial())
    place(window, *row, x, time);
  else
    place(window, *problem.linked(), x, time);
  values_.resize(window.lanes.count);
}

Expansion& Stepper::expansion() {
  const auto size = size_for(window.lanes);
  auto& chosen = expansions_[size];
  if (!chosen) chosen = make_expansion(size);
  return *chosen;
}

void Stepper::shorten(Piece& piece, double place) {
  piece.lands = piece.lands && place == piece.end;
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
  if (l.damped || l.general) return false;
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

/// The lane whose onset or separation limits a series in time.
int Stepper::choose_clock() const {
  const auto& l = window.lanes;
  int clock = Expansion::plain;
  if (l.general) return clock;
  if (l.widened) return narrowest();
  double soonest = landing_share(window) * last_time;
  for (int j = 0; j < l.count; ++j) {
    if (!window.is_sharp(j) || window.contact(j).role != Role::closed) continue;
    if (is_struck(j)) return j;
    if (!(l.rate[j] < 0) || !(l.indentation[j] < -soonest * l.rate[j])) continue;
    soonest = -l.indentation[j] / l.rate[j];
    clock = j;
  }
  return clock;
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
/// convergence: beyond, a weak singularity, a contact about to let go, hides behind small coefficients.
double Stepper::reach(const Expansion& series, bool fresh) const {
  const int order = precision_.order, group = fresh ? 5 : 2;  // right after an onset four of five vanish
  double end = infinity, last = tiny, before = tiny, size[10];
  series.sizes(order - 2 * group + 1, size);
  for (int i = 0; i < group; ++i) {
    const double highest = std::max(size[group + i], tiny);
    end = std::min(end, rough_root(precision_.tolerance / highest, order - group + 1 + i));
    last = std::max(last, highest);
    before = std::max(before, size[i]);
  }
  return std::min(end, safe_radius * rough_root(before / last, group));
}

Piece Stepper::series_piece() {
  auto& l = window.lanes;
  Piece piece{.series = &expansion(), .order = precision_.order, .clock = choose_clock()};
  for (int j = 0; j < l.count; ++j) {
    l.active[j] = window.pushes(j) && (j == piece.clock || l.indentation[j] > window.wake[j]);
    if (window.network) doze(j);
    if (l.steepening[j] > 0) listen(j);
  }
  piece.series->expand(l, piece.order, piece.clock);
  const double end = reach(*piece.series, piece.clock != Expansion::plain && l.indentation[piece.clock] == 0);
  piece.end = end;
  if (piece.clock != Expansion::plain) land(piece);
  shorten(piece, piece.end);
  return piece;
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

/// What touches and is left out is watched for the depth at which it would be late.
void Stepper::doze(int lane) {
  auto& l = window.lanes;
  if (window.contact(lane).role != Role::touching || !window.is_sharp(lane)) return;
  l.side[lane] = l.active[lane] > 0 ? 0 : -1;
  l.level[lane] = late * window.wake[lane];
}

/// A slack contact whose load has a power of δ is watched for it only where its own force would be heard.
void Stepper::listen(int lane) {
  auto& l = window.lanes;
  if (window.contact(lane).role != Role::slack) return;
  l.load_side[lane] = l.indentation[lane] > window.wake[lane] ? -1 : 0;
}

bool Stepper::dozes(int lane) const {
  return window.lanes.side[lane] < 0 && window.contact(lane).role == Role::touching;
}

/// In a row the others only press a contact whose own force is left out, so that it is deepest at an end of a
/// piece, unless a drive draws it apart. Other links may draw it, too.
bool Stepper::cannot_be_late(const Piece& piece, int lane) const {
  if (values_.indentation[lane] > late * window.wake[lane]) return false;
  if (!window.network) return !(window.lanes.drive[lane] < 0);
  return piece.start || (dozes(lane) && values_.margin[lane] >= 0);
}

/// End the piece where a contact whose force is left out has reached the depth at which it wakes.
void Stepper::wake_gently(Piece& piece) {
  const auto& l = window.lanes;
  for (int j = 0; j < l.count; ++j) {
    if (!window.pushes(j) || l.active[j] > 0) continue;
    if (cannot_be_late(piece, j)) continue;
    if (piece.start) {
      wake_in_start(piece, j);
    } else if (const auto place = waking(piece, j)) {
      piece.is_cut = false;
      shorten(piece, *place);
    }
  }
}

/// If the indentation gets late, the place at which it has not yet done so.
std::optional<double> Stepper::waking(const Piece& piece, int lane) const {
  Coefficients c;
  const auto used = piece.coefficients(Quantity::indentation, lane, c);
  for (double& coefficient : c) coefficient = -coefficient;
  const double depth = late * window.wake[lane];
  c[0] += depth;
  const auto place = flow::first_fall(used, piece.end);
  if (!place) return std::nullopt;
  c[0] -= (1 - in_time) * depth;
  return flow::first_fall(used, *place);
}

/// In a start series what is left out only sinks deeper. Depths grow with some power of time.
void Stepper::wake_in_start(Piece& piece, int lane) {
  const double depth = std::max(window.lanes.indentation[lane], 0.0),
               goal = in_time * late * window.wake[lane];
  for (int tries = 0; tries < 60 && values_.indentation[lane] > late * window.wake[lane]; ++tries) {
    const double secant = depth > 0 ? (goal - depth) / (values_.indentation[lane] - depth) : 0;
    const double power = rough_root(goal / values_.indentation[lane], 4);
    shorten(piece, piece.end * std::clamp(std::max(secant, power), 0.1, 0.98));
  }
}

Piece Stepper::next(bool first, double time) {
  auto start = first ? start_piece() : std::nullopt;
  Piece piece = start ? *start : series_piece();
  wake_gently(piece);
  piece.is_cut = !(values_.time < time);
  if (piece.is_cut) {
    shorten(piece, piece.place(time, values_.time));
    values_.time = time;
  }
  return piece;
}

void Stepper::search(const Piece& piece, Quantity quantity, int lane, double side, double level, Index guard,
                     Fall& fall) const {
  Coefficients c;
  const auto used = piece.coefficients(quantity, lane, c);
  for (double& coefficient : c) coefficient *= side;
  c[0] += level;
  const auto place = flow::first_fall(used, std::min(piece.end, fall.place));
  if (place && *place < fall.place) fall = {guard, lane, *place};
}

/// Where a branch ends: the contact yields or turns.
void Stepper::search_branch(const Piece& piece, int lane, Fall& fall) const {
  const auto& l = window.lanes;
  const Index yields = window.contact(lane).branch_guard, turns = yields + 1;
  if (l.yield_side[lane] > 0)
    search(piece, Quantity::indentation, lane, -1, l.yield_level[lane], yields, fall);
  if (l.turn_side[lane] != 0)
    search(piece, Quantity::rate, lane, l.turn_side[lane], l.turn_level[lane], turns, fall);
}

/// End the piece where the root of an indentation passes zero. A contact that comes to δ = 0 and turns there
/// goes on as √δ = |t|, and its series as t: beyond, the contact would pull.
void Stepper::end_at_turn(Piece& piece, int lane) {
  const auto& l = window.lanes;
  if (lane == piece.clock || !(l.active[lane] > 0) || !window.is_sharp(lane)) return;
  Coefficients c;
  const auto place = flow::first_fall(piece.coefficients(Quantity::root, lane, c), piece.end);
  if (!place || !(*place < piece.end)) return;
  piece.is_cut = false;
  shorten(piece, *place);
}

Fall Stepper::first_fall(Piece& piece) {
  Fall fall;
  if (!piece.series) return fall;  // a start is chosen so short that none fires
  const auto& l = window.lanes;
  if (std::any_of(values_.margin, values_.margin + l.count, [](double margin) { return margin < 0; }))
    piece.series->sharpen(piece.end, values_);
  for (int j = 0; j < l.count; ++j)
    if (l.side[j] > 0 && values_.margin[j] < 0) end_at_turn(piece, j);
  for (int j = 0; j < l.count; ++j) {
    const auto& c = window.contact(j);
    if (l.side[j] != 0 && !dozes(j) && values_.margin[j] < 0)
      search(piece, Quantity::indentation, j, l.side[j], l.level[j], c.guard, fall);
    if (l.load_side[j] != 0 && values_.load_margin[j] < 0)
      search(piece, Quantity::load, j, l.load_side[j], load_noise(window, j), c.load_guard, fall);
    if (l.branched && values_.branch_margin[j] < 0) search_branch(piece, j, fall);
  }
  if (piece.lands && fall.guard < 0) {  // one that comes down to δ = 0 may have lost its load, too
    const auto& c = window.contact(piece.clock);
    fall = {c.opens_loaded() ? c.guard : c.load_guard, piece.clock, piece.end};
  }
  if (fall.guard >= 0) end_at(fall, piece);
  return fall;
}

/// Behind its fall a neighbour would pull, and hide that a contact has been late before.
void Stepper::end_at(Fall& fall, Piece& piece) {
  shorten(piece, fall.place);
  wake_gently(piece);
  if (piece.end < fall.place) fall = {};
}

void Stepper::advance(const Piece& piece, const Fall& fall) {
  auto& l = window.lanes;
  last_time = values_.time;
  taylor::advance(window, values_);
  if (piece.clock != Expansion::plain) watch(window, piece.clock);
  if (fall.guard < 0) return;
  if (piece.lands && fall.lane == piece.clock) l.indentation[fall.lane] = 0;
  const auto& c = window.contact(fall.lane);
  if (fall.guard == c.guard) l.indentation[fall.lane] = 0 - l.side[fall.lane] * l.level[fall.lane];
  if (fall.guard == c.branch_guard) l.indentation[fall.lane] = l.yield_level[fall.lane];
}

}  // namespace mariotte::flow::taylor
