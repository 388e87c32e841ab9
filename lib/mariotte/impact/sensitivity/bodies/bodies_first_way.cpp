// Where slips in space go that leave rest, with slopes: against the friction that would hold them.
#include <algorithm>
#include <cmath>

#include "mariotte/impact/sensitivity/bodies/bodies_variation.hpp"

namespace mariotte::impact {

using model::BodiesMode;
using model::ClosedContact;
using model::Friction;
using model::Sloped;
using model::Vec;

namespace {

using model::slope_lanes;

/// Contacts that leave rest as none has done before.
std::vector<Index> leaving(const BodiesMode& before, const BodiesMode& after) {
  std::vector<Index> places;
  for (std::size_t i = 0; i < after.closed.size(); ++i) {
    const auto& one = after.closed[i];
    const Index was = place_of(before, one.contact);
    const bool goes_on = was >= 0 && before.closed[was].from_rest && before.closed[was].start == one.start;
    if (one.from_rest && !goes_on) places.push_back(static_cast<Index>(i));
  }
  return places;
}

BodiesMode holding(BodiesMode mode, const std::vector<Index>& places) {
  for (const Index i : places) mode.closed[i].friction = Friction::stick;
  return mode;
}

/// Whether a direction is the one that a run has taken, but for rounding.
template <int D>
bool agrees(const Vec<Sloped, D>& way, const std::vector<double>& taken) {
  constexpr double tolerance = 1e-8;
  for (int k = 0; k < D; ++k)
    if (!(std::abs(way[k].value - taken[k]) <= tolerance)) return false;
  return true;
}

}  // namespace

/// Several that leave rest at one instant have done so one after the other: each while the rest held still,
/// or slipped already.
template <int D>
void BodiesVariation<D>::begin(const Mode& before, const Mode& after, ConstState x,
                               const SlopeMatrix& slopes) {
  see_landings(before, after, x, slopes);
  const auto places = leaving(before, after);
  for (const Index place : places)
    if (!set_way(place, after, holding(after, {place}), x, slopes) &&
        !set_way(place, after, holding(after, places), x, slopes)) {
      for (auto& field : field_) field.set_start(after.closed[place].slot, std::nullopt);
      has_unknown_way_ = true;
    }
}

/// Contacts that close without slip and slip at once.
template <int D>
void BodiesVariation<D>::see_landings(const Mode& before, const Mode& after, ConstState x,
                                      const SlopeMatrix& slopes) {
  constexpr double rounding = 1e-9;
  const double rest = base_.rest_speed();
  for (const auto& one : after.closed) {
    const auto& tangential = base_.contact[one.contact].tangential;
    if (place_of(before, one.contact) >= 0 || one.friction != Friction::slip || tangential.has_spring())
      continue;
    for (Index first = 0; first < columns(); first += slope_lanes) {
      const auto slip = evaluate(first, after, x, slopes).motion(one.contact).slip;
      double square = 0;
      for (int k = 0; k < D; ++k) square += slip[k].value * slip[k].value;
      if (square > rest * rest) break;
      for (Index c = first; c < std::min(first + slope_lanes, columns()); ++c)
        for (int k = 0; k < D; ++k)
          if (std::abs(slip[k].slope[c - first]) > rounding * base_.speed * natural_[c]) one_sided_[c] = true;
    }
  }
}

/// False if another direction than this has been taken.
template <int D>
bool BodiesVariation<D>::set_way(Index place, const Mode& mode, const Mode& held, ConstState x,
                                 const SlopeMatrix& slopes) {
  const auto& one = mode.closed[place];
  for (Index first = 0; first < columns(); first += slope_lanes) {
    auto& field = evaluate(first, held, x, slopes);
    const auto& friction = field.contact(place).friction;
    const auto way = Sloped(-1.0) / norm(friction) * friction;
    if (!agrees(way, one.start)) return false;
    field.set_start(one.slot, way);
  }
  return true;
}

template void BodiesVariation<2>::begin(const BodiesMode&, const BodiesMode&, ConstState, const SlopeMatrix&);
template void BodiesVariation<3>::begin(const BodiesMode&, const BodiesMode&, ConstState, const SlopeMatrix&);

}  // namespace mariotte::impact
