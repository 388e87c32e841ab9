#include "mariotte/flow/taylor/tip_series.hpp"

#include "mariotte/flow/taylor/tip_expansions.hpp"

namespace mariotte::flow {

template <>
struct NormalSeries::Memory : TipExpansions<NormalField<false>, NormalField<true>> {};

template <>
struct PlanarSeries::Memory : TipExpansions<PlanarField<false, false>, PlanarField<false, true>,
                                            PlanarField<true, false>, PlanarField<true, true>> {};

template <>
void NormalSeries::expand(const TipPhase& phase, int order) {
  rows_ = phase.place.work < 0 ? memory_->expand<NormalField<false>>(*this, order)
                               : memory_->expand<NormalField<true>>(*this, order);
}

template <>
void PlanarSeries::expand(const TipPhase& phase, int order) {
  if (phase.place.work < 0)
    rows_ = phase.sticking ? memory_->expand<PlanarField<true, false>>(*this, order)
                           : memory_->expand<PlanarField<false, false>>(*this, order);
  else
    rows_ = phase.sticking ? memory_->expand<PlanarField<true, true>>(*this, order)
                           : memory_->expand<PlanarField<false, true>>(*this, order);
}

template <class Motion>
TipSeries<Motion>::TipSeries() : memory_(std::make_unique<Memory>()) {}
template <class Motion>
TipSeries<Motion>::~TipSeries() = default;

template class TipSeries<NormalMotion>;
template class TipSeries<PlanarMotion>;

}  // namespace mariotte::flow
