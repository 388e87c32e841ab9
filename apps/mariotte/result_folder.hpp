// What `--out DIR` leaves in DIR.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "mariotte/impact/bodies/bodies_impact.hpp"
#include "mariotte/impact/chain/chain_impact.hpp"
#include "mariotte/impact/microbody/microbody_impact.hpp"
#include "mariotte/impact/network/network_impact.hpp"
#include "mariotte/report/figure/spacetime.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::command {

/// Whether samples of the scene fit into memory and files of sensible size.
bool can_trace(const scene::Scene& scene);

/// Names of all files that a run may leave in its folder.
std::vector<std::string> result_names();

/// Those that are in the folder.
std::vector<std::string> result_files(const std::filesystem::path& folder);

/// A run has written there.
bool has_result(const std::filesystem::path& folder);

/// Create the folder; without `force`, throw report::FileError if it holds a file that would be written.
void prepare_result_folder(const std::filesystem::path& folder, bool force);

/// Write the result files, replacing those of an earlier run. Returns an empty text, or why there are no
/// figures; `waves` may be null. Throws report::FileError.
std::string write_result_folder(const std::filesystem::path& folder, const report::Json& json,
                                const impact::ChainImpact& impact, const scene::Scene& scene,
                                const report::Spacetime* waves);
std::string write_result_folder(const std::filesystem::path& folder, const report::Json& json,
                                const impact::NetworkImpact& impact, const scene::Scene& scene);
std::string write_result_folder(const std::filesystem::path& folder, const report::Json& json,
                                const impact::MicrobodyImpact& impact, const scene::Scene& scene);
std::string write_result_folder(const std::filesystem::path& folder, const report::Json& json,
                                const impact::BodiesImpact& impact, const scene::Scene& scene);

}  // namespace mariotte::command
