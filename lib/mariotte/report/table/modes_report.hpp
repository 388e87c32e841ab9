// Natural modes as JSON and table.
#pragma once
#include <string>

#include "mariotte/report/json/json.hpp"
#include "mariotte/study/modes.hpp"

namespace mariotte::report {

/// `rest` with `force`, `indentation` and `stiffness` per contact, `angular_frequency`, `rigid_motions`, and
/// `band_edges` of rows that have them.
Json json(const study::Modes& modes);

/// Contacts at rest, frequencies, and the bands.
std::string table(const study::Modes& modes, const std::string& title);

}  // namespace mariotte::report
