#include "mariotte/flow/taylor/tip_expansions.hpp"

#include "mariotte/series/dual.hpp"
#include "mariotte/series/field.hpp"

namespace mariotte::flow {

double turn_response(const TipStart<SpatialMotion>& from, const std::array<double, 2>& across) {
  using Field = SpatialField<Grip::from_rest, true>;
  using Number = series::Dual<double, 1>;
  series::States<Field, Number> x;
  series::Parameters<Field, Number> p;
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = from.start[i];
  for (std::size_t i = 0; i < p.size(); ++i) p[i] = from.parameter[i];
  for (int i = 0; i < 2; ++i) x[from.direction + i].slope[0] = across[i];
  const auto row = Field::rates(x, p);
  return across[0] * row[from.slip_rate].slope[0] + across[1] * row[from.slip_rate + 1].slope[0];
}

}  // namespace mariotte::flow
