// The series of a tip, one for each motion and grip. Included by one source file per instruction set, which
// names the namespace it lives in.
#pragma once
#include <tuple>

#include "mariotte/flow/taylor/tip_from_rest.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::flow::tips::MARIOTTE_INSTRUCTION_SET {

template <class Field>
struct Packed : Field {
  static constexpr int packed = MARIOTTE_VECTOR_BYTES / 8;
};
template <class Field>
struct Expansion : series::Series<Packed<Field>, most_order, double> {
  Expansion() {}  // leaves most of its memory as it is
};

/// Each has memory once it is used.
template <class... Fields>
class Memory {
 public:
  template <class Field>
  Expansion<Field>& get() {
    auto& one = std::get<std::unique_ptr<Expansion<Field>>>(all_);
    if (!one) one = std::make_unique<Expansion<Field>>();
    return *one;
  }

 private:
  std::tuple<std::unique_ptr<Expansion<Fields>>...> all_;
};

using FromRest = SpatialField<Grip::from_rest, true>;

class Expansions final : public TipExpansions {
 public:
  const PowerSeries* expand(const TipPhase& phase, const TipStart<NormalMotion>& from, int order,
                            int known) override {
    return follows_works(phase) ? by<NormalField<true>>(from, order, known)
                                : by<NormalField<false>>(from, order, known);
  }
  const PowerSeries* expand(const TipPhase& phase, const TipStart<PlanarMotion>& from, int order,
                            int known) override {
    return phase.sticking ? planar<true>(phase, from, order, known)
                          : planar<false>(phase, from, order, known);
  }
  const PowerSeries* expand(const TipPhase& phase, const TipStart<SpatialMotion>& from, int order,
                            int known) override {
    if (phase.sticking) return spatial<Grip::sticking>(phase, from, order, known);
    if (phase.friction == 0) return spatial<Grip::none>(phase, from, order, known);
    if (phase.slip != TipPhase::Slip::moving) return from_rest(phase, from, order);
    return phase.indented ? spatial<Grip::sinking_sliding>(phase, from, order, known)
                          : spatial<Grip::sliding>(phase, from, order, known);
  }

 private:
  static bool follows_works(const TipPhase& phase) { return phase.place.work >= 0; }

  /// The first row, after expansion.
  template <class Field>
  const PowerSeries* by(const TipStart<typename Field::Motion>& from, int order, int known) {
    auto& expansion = memory_.get<Field>();
    expansion.expand(from.start, from.parameter, order, known);
    return &expansion[0];
  }
  template <bool sticks>
  const PowerSeries* planar(const TipPhase& phase, const TipStart<PlanarMotion>& from, int order, int known) {
    return follows_works(phase) ? by<PlanarField<sticks, true>>(from, order, known)
                                : by<PlanarField<sticks, false>>(from, order, known);
  }
  template <Grip grip>
  const PowerSeries* spatial(const TipPhase& phase, const TipStart<SpatialMotion>& from, int order,
                             int known) {
    return follows_works(phase) ? by<SpatialField<grip, true>>(from, order, known)
                                : by<SpatialField<grip, false>>(from, order, known);
  }
  const PowerSeries* from_rest(const TipPhase& phase, const TipStart<SpatialMotion>& from, int order) {
    auto& expansion = memory_.get<FromRest>();
    SlipFromRest(expansion, from).expand(order, phase.slip == TipPhase::Slip::breaking);
    return &expansion[0];
  }

  template <Grip grip>
  using Quick = SpatialField<grip, false>;
  template <Grip grip>
  using Full = SpatialField<grip, true>;
  Memory<NormalField<false>, NormalField<true>, PlanarField<false, false>, PlanarField<false, true>,
         PlanarField<true, false>, PlanarField<true, true>, Quick<Grip::none>, Quick<Grip::sliding>,
         Quick<Grip::sinking_sliding>, Quick<Grip::sticking>, Full<Grip::none>, Full<Grip::sliding>,
         Full<Grip::sinking_sliding>, Full<Grip::sticking>, FromRest>
      memory_;
};

}  // namespace mariotte::flow::tips::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::flow::TipExpansions>
mariotte::flow::MARIOTTE_INSTRUCTION_SET::make_tip_expansions() {
  return std::unique_ptr<TipExpansions>(new tips::MARIOTTE_INSTRUCTION_SET::Expansions);
}
