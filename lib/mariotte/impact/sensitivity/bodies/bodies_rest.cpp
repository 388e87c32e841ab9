// Slopes where a slip comes to rest. It does so along every direction at once, whatever parameters are, so
// none of it is left behind the event. Just before, the direction of the slip is rounding, and in space
// slopes of that are not resolved; what they miss is friction along the contact, an impulse. It is the one
// that takes away the slip that is left. A contact that closes without slip rests at once, and so does any
// slip next to none.
#include <algorithm>

#include "mariotte/impact/sensitivity/bodies/bodies_variation.hpp"

namespace mariotte::impact {

using model::BodiesLayout;
using model::BodiesMode;
using model::ClosedContact;
using model::Friction;
using model::Sloped;
using model::Vec;

namespace {

using model::slope_lanes;

/// Its slopes alone.
template <int D>
Vec<Sloped, D> varied(Vec<Sloped, D> slip) {
  for (auto& part : slip.at) part.value = 0;
  return slip;
}

/// Adds what impulses do to slopes by as many parameters as are carried side by side.
template <int D>
class Impulses {
 public:
  using Setting = SlopedSetting<D>;
  using Vector = Vec<Sloped, D>;

  Impulses(const Setting& setting, const BodiesLayout<D>& at, Index first, SlopeMatrix& slopes)
      : setting_(setting),
        at_(at),
        first_(first),
        count_(std::min(slope_lanes, slopes.columns - first)),
        slopes_(slopes) {}

  /// On b of a contact, and the opposite on a.
  void push(const ClosedContact& one, const model::ContactMotion<Sloped, D>& motion,
            const Vector& impulse) const {
    const auto& contact = setting_.contact[one.contact];
    push_body(setting_.sphere[contact.b].body, motion.lever_b, impulse);
    if (contact.plane < 0) push_body(setting_.sphere[contact.a].body, motion.lever_a, Sloped(-1.0) * impulse);
    if constexpr (D == 2)
      add(at_.tangential(one.slot), Vec<Sloped, 1>{{dot(impulse, across(motion.normal))}});
    else
      add(at_.tangential(one.slot), impulse);
  }

 private:
  template <int N>
  void add(Index row, const Vec<Sloped, N>& part) const {
    for (int k = 0; k < N; ++k)
      for (Index c = 0; c < count_; ++c) slopes_(row + k, first_ + c) += part[k].slope[c];
  }
  void push_body(Index i, const Vector& lever, const Vector& impulse) const {
    const auto& body = setting_.body[i];
    add(at_.velocity(i), (1 / body.mass) * impulse);
    const auto turn = moment(lever, impulse);
    if constexpr (D == 2)
      add(at_.momentum(i), (1 / body.inertia[0]) * turn);
    else
      add(at_.momentum(i), turn);
  }

  const Setting& setting_;
  const BodiesLayout<D>& at_;
  Index first_, count_;
  SlopeMatrix& slopes_;
};

}  // namespace

template <int D>
bool BodiesVariation<D>::comes_to_rest(const Mode& before, const Mode& after) const {
  return std::any_of(after.closed.begin(), after.closed.end(), [&](const ClosedContact& one) {
    const Index place = place_of(before, one.contact);
    const auto& tangential = base_.contact[one.contact].tangential;
    return one.friction == Friction::stick && tangential.friction > 0 && !tangential.has_spring() &&
           (place < 0 || before.closed[place].friction != Friction::stick);
  });
}

template <int D>
void BodiesVariation<D>::stop_slip(const Mode& mode, ConstState x, SlopeMatrix& slopes) {
  const auto at = system_.layout(x);
  for (Index first = 0; first < columns(); first += slope_lanes) {
    auto& field = evaluate(first, mode, x, slopes);
    const auto& impulse = field.stopping([&](Index contact) { return varied(field.motion(contact).slip); });
    const Impulses<D> impulses(field.setting(), at, first, slopes);
    for (std::size_t k = 0; k < impulse.size(); ++k) {
      const std::size_t place = field.stuck()[k].place;
      impulses.push(mode.closed[place], field.contact(place).motion, impulse[k]);
    }
  }
}

template bool BodiesVariation<2>::comes_to_rest(const BodiesMode&, const BodiesMode&) const;
template bool BodiesVariation<3>::comes_to_rest(const BodiesMode&, const BodiesMode&) const;
template void BodiesVariation<2>::stop_slip(const BodiesMode&, ConstState, SlopeMatrix&);
template void BodiesVariation<3>::stop_slip(const BodiesMode&, ConstState, SlopeMatrix&);

}  // namespace mariotte::impact
