// The numbers of a chain's result that its quickest run has, by their key.
#pragma once
#include <optional>
#include <string_view>

#include "mariotte/impact/chain_solver.hpp"
#include "mariotte/model/chain.hpp"

namespace mariotte::study {

/// A brief result and the chain it belongs to.
struct BriefResult {
  const model::Chain& chain;
  const impact::BriefImpact& impact;
};

/// One of these numbers.
struct BriefQuantity {
  double (*read)(const BriefResult&,
                 std::size_t);  ///< nan where it is undefined, or the index beyond its end
  std::size_t index = 0;
};

/// Of a result key, as "icr[0]"; none if only the whole result has it.
std::optional<BriefQuantity> brief_quantity(std::string_view key);

}  // namespace mariotte::study
