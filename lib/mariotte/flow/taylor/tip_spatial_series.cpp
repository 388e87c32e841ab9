#include "mariotte/flow/taylor/tip_expansions.hpp"
#include "mariotte/series/dual.hpp"

namespace mariotte::flow {
namespace {

using FromRest = SpatialField<Grip::from_rest, true>;

Grip grip_of(const TipPhase& phase) {
  if (phase.sticking) return Grip::sticking;
  if (phase.friction == 0) return Grip::none;
  if (phase.slip != TipPhase::Slip::moving) return Grip::from_rest;
  return phase.indented ? Grip::sinking_sliding : Grip::sliding;
}

/// How fast a turn of û along `across` changes u' along it.
double response(const SpatialSeries& from, const std::array<double, 2>& across) {
  using Number = series::Dual<double, 1>;
  series::States<FromRest, Number> x;
  series::Parameters<FromRest, Number> p;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = from.start[i];
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = from.parameter[i];
  for (int i = 0; i < 2; ++i) x[from.direction + i].slope[0] = across[i];
  const auto row = FromRest::rates(x, p);
  return across[0] * row[from.slip_rate].slope[0] + across[1] * row[from.slip_rate + 1].slope[0];
}

/// A slip from rest, u = ρ û with |û| = 1. Order k of |û|² = 1 gives û_k along û_0. Across it and along it
/// order k of (ρ û)' = u', where ρ_0 = 0, gives the rest of û_k and ρ_{k+1}: u'_k changes with û_k at a known
/// rate, so it is expanded with û_k along û_0 first.
class SlipFromRest {
 public:
  SlipFromRest(TipExpansion<FromRest>& expansion, const SpatialSeries& from)
      : from_(from),
        expansion_(expansion),
        first_{from.start[from.direction], from.start[from.direction + 1]} {}

  void expand(int order, bool breaking) {
    expansion_.begin(from_.start, from_.parameter);
    const double across = response(from_, across_);
    speed_[1] = breaking ? 0 : along(slip_rate(0));
    for (int k = 1; k <= order; ++k) {
      const double bend = bent(k);
      turn(k, bend, 0);
      const double rest = dot(across_, slip_rate(k)) - (k + 1) * dot(across_, carried(k));
      turn(k, bend, rest / ((k + 1) * speed_[1] - across));
      speed_[k + 1] = along(slip_rate(k)) / (k + 1) - along(carried(k)) - speed_[1] * bend;
    }
  }

 private:
  using Plane = std::array<double, 2>;
  static double dot(const Plane& a, const Plane& b) { return a[0] * b[0] + a[1] * b[1]; }
  double along(const Plane& a) const { return dot(first_, a); }
  Plane at(int row, int k) const { return {expansion_[row][k], expansion_[row + 1][k]}; }
  Plane slip_rate(int k) const { return at(from_.slip_rate, k); }
  Plane direction(int k) const { return at(from_.direction, k); }

  double bent(int k) const {
    double sum = 0;
    for (int j = 1; j < k; ++j) sum -= 0.5 * dot(direction(j), direction(k - j));
    return sum;
  }
  /// Coefficient k + 1 of ρ û without its first and last terms.
  Plane carried(int k) const {
    Plane sum{};
    for (int j = 2; j <= k; ++j)
      for (int i = 0; i < 2; ++i) sum[i] += speed_[j] * direction(k + 1 - j)[i];
    return sum;
  }
  void turn(int k, double bend, double across) {
    for (int i = 0; i < 2; ++i) expansion_[from_.direction + i][k] = bend * first_[i] + across * across_[i];
    expansion_.stage(k);
  }

  const SpatialSeries& from_;
  TipExpansion<FromRest>& expansion_;
  Plane first_, across_{-first_[1], first_[0]};
  PowerSeries speed_ = {};
};

template <Grip grip>
using Quick = SpatialField<grip, false>;
template <Grip grip>
using Full = SpatialField<grip, true>;
using Expansions = TipExpansions<Quick<Grip::none>, Quick<Grip::sliding>, Quick<Grip::sinking_sliding>,
                                 Quick<Grip::sticking>, Full<Grip::none>, Full<Grip::sliding>,
                                 Full<Grip::sinking_sliding>, Full<Grip::sticking>, FromRest>;

template <Grip grip>
const PowerSeries* expand_by(Expansions& all, const TipPhase& phase, const SpatialSeries& from, int order) {
  return phase.place.work < 0 ? all.expand<Quick<grip>>(from, order) : all.expand<Full<grip>>(from, order);
}

const PowerSeries* expand_from_rest(Expansions& all, const TipPhase& phase, const SpatialSeries& from,
                                    int order) {
  auto& expansion = all.get<FromRest>();
  SlipFromRest(expansion, from).expand(order, phase.slip == TipPhase::Slip::breaking);
  return &expansion[0];
}

const PowerSeries* expand_any(Expansions& all, const TipPhase& phase, const SpatialSeries& from, int order) {
  switch (grip_of(phase)) {
    case Grip::none:
      return expand_by<Grip::none>(all, phase, from, order);
    case Grip::sliding:
      return expand_by<Grip::sliding>(all, phase, from, order);
    case Grip::sinking_sliding:
      return expand_by<Grip::sinking_sliding>(all, phase, from, order);
    case Grip::sticking:
      return expand_by<Grip::sticking>(all, phase, from, order);
    case Grip::from_rest:
      break;
  }
  return expand_from_rest(all, phase, from, order);
}

}  // namespace

template <>
struct SpatialSeries::Memory : Expansions {};

template <>
void SpatialSeries::expand(const TipPhase& phase, int order) {
  rows_ = expand_any(*memory_, phase, *this, order);
}

template <>
SpatialSeries::TipSeries() : memory_(std::make_unique<Memory>()) {}
template <>
SpatialSeries::~TipSeries() = default;

}  // namespace mariotte::flow
