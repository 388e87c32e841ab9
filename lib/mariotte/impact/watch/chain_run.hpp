// What a chain does from start to end, followed as one system or as islands.
#pragma once
#include <optional>

#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/watch/peaks.hpp"
#include "mariotte/model/islands/islands.hpp"

namespace mariotte::impact {

/// All dimensionless but the trace.
struct ChainRun {
  model::Islands::Run run;
  contact::ContactSet mode;                   ///< at the end
  std::vector<Peak> peaks;                    ///< of each contact
  std::optional<model::IslandCount> islands;  ///< empty if the chain was one system
  Trace trace;
};

/// Chains of fewer balls are one system, if the choice is automatic: as cheap, and nothing has to be cut.
inline constexpr std::size_t balls_for_islands = 48;

/// Errors add up along a chain: behind a wave that has passed n contacts they are about n/1000 of the
/// accuracy of its flow, as measured. The options for an answer as accurate as was asked.
hybrid::Options tightened(hybrid::Options options, std::size_t balls);

/// Whether a chain of so many balls is divided.
bool divides(const hybrid::Options& options, const model::Chain& chain);
/// Adhesion may hold balls together for ever, which only the whole chain can tell.
bool is_one_system(const model::Chain& chain);

/// The chain as one system. `options` are dimensionless.
ChainRun follow_whole(model::ChainSystem& system, ConstState start, const hybrid::Options& options,
                      const RunObserver& observers);

/// The chain as islands; `observer` may be null.
ChainRun follow_islands(const model::DimensionlessChain& chain, const model::ChainLayout& layout,
                        ConstState start, const hybrid::Options& options, bool stay,
                        model::SnapshotObserver* observer);

}  // namespace mariotte::impact
