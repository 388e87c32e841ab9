#include "mariotte/model/microbody/microbody_field.hpp"

namespace mariotte::model {
namespace {

/// What rates depend on: not on where the body is along the plane, nor on energies dissipated so far.
constexpr int most_columns = 12;
using Slopes = series::Dual<double, most_columns>;

/// Their places in the state, in order.
std::vector<Index> columns(const MicrobodyLayout& layout) {
  const auto& place = layout.place;
  std::vector<Index> result;
  const auto add = [&](Index first, Index count) {
    for (Index i = 0; i < count; ++i) result.push_back(first + i);
  };
  for (Index i = 0; i < layout.tips; ++i) add(place.gap[i], 1);
  add(place.velocity, 3);
  add(place.attitude, 4);
  add(place.momentum, 3);
  return result;
}

}  // namespace

std::vector<flow::Entry> Mechanics::pattern() const {
  std::vector<flow::Entry> entries;
  for (const Index column : columns(layout))
    for (Index row = 0; row < layout.size; ++row) entries.push_back({row, column});
  return entries;
}

void Mechanics::jacobian(ConstState x, const MicrobodyMode& mode, State values) const {
  const auto places = columns(layout);
  std::vector<Slopes> at(x.begin(), x.end()), rates(x.size());
  for (std::size_t i = 0; i < places.size(); ++i) at[places[i]].slope[i] = 1;
  MicrobodyField<Slopes>(*this, at).rates(mode, rates);
  auto entry = values.begin();
  for (std::size_t i = 0; i < places.size(); ++i)
    for (const auto& rate : rates) *entry++ = rate.slope[i];
}

}  // namespace mariotte::model
