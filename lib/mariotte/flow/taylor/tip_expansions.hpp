// The expansions of the fields of one motion: each has memory once it is used.
#pragma once
#include <tuple>

#include "mariotte/flow/taylor/tip_series.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::flow {

template <class Field>
using TipExpansion = series::Series<Field, most_order, double>;

template <class... Fields>
class TipExpansions {
 public:
  template <class Field>
  TipExpansion<Field>& get() {
    auto& one = std::get<std::unique_ptr<TipExpansion<Field>>>(all_);
    if (!one) one = std::make_unique<TipExpansion<Field>>();
    return *one;
  }
  /// The first row, after expansion.
  template <class Field>
  const PowerSeries* expand(const TipSeries<typename Field::Motion>& from, int order) {
    auto& expansion = get<Field>();
    expansion.expand(from.start, from.parameter, order);
    return &expansion[0];
  }

 private:
  std::tuple<std::unique_ptr<TipExpansion<Fields>>...> all_;
};

}  // namespace mariotte::flow
