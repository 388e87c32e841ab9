// The numbers of a result that the quickest run of a chain or a body has, by their key.
#pragma once
#include <optional>
#include <string_view>

#include "mariotte/impact/chain/chain_solver.hpp"
#include "mariotte/impact/microbody/microbody_solver.hpp"
#include "mariotte/model/chain/chain.hpp"

namespace mariotte::study {

/// A brief result and the chain it belongs to.
struct BriefChain {
  const model::Chain& chain;
  const impact::BriefImpact& impact;
};

/// A brief result and the body it belongs to, which has one impact.
struct BriefBody {
  const model::Microbody& body;
  const impact::BriefMicrobodyImpact& impact;
};

/// One number of such a result: nan where it is undefined, or the index beyond its end.
template <class Brief>
struct BriefQuantity {
  double (*read)(const Brief&, std::size_t);
  std::size_t index = 0;
};

/// Of a result key, as "icr[0]"; none if only the whole result has it.
std::optional<BriefQuantity<BriefChain>> brief_quantity_of_chain(std::string_view key);
/// As "restitution.tip".
std::optional<BriefQuantity<BriefBody>> brief_quantity_of_body(std::string_view key);

}  // namespace mariotte::study
