// Columns of a sweep that are slopes: "sensitivity.OUTCOME.NUMBER", as "sensitivity.velocity[2].mass[0]" or
// "sensitivity.time.chain.radius", by the names of `mariotte sensitivity`.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/scene/document.hpp"

namespace mariotte::study {

/// The slope of one outcome by one number, of the model or of the scene.
struct SlopeColumn {
  std::size_t column;  ///< its number among all
  std::string outcome, number;
};

bool is_slope(std::string_view key);

/// Of a key that is a slope.
SlopeColumn slope_column(std::string_view key, std::size_t column);

/// A scene as it is written, and as it is read.
struct WrittenScene {
  const scene::Document& document;
  const scene::Scene& scene;
};

/// Each of the slopes that a key with [*] for an index stands for.
std::vector<std::string> each_slope(const std::string& key, const WrittenScene& example, bool may_run);

/// Throws ColumnError if this scene has no such outcome, or no such number. Balls in a row or a network have
/// outcomes that are known; bodies have to be run to tell theirs, if they `may_run`.
void expect_slope(const std::string& key, const WrittenScene& example, bool may_run);

/// That of the outcome by that of the number, "kg^-1 m s^-1"; "SI" where one of them is not known.
std::string unit_of_slope(const std::string& key, const WrittenScene& example);

/// Fills in slopes by one run with slopes, nan where there is none. Returns what its notes say of them.
std::string fill_slopes(const WrittenScene& point, const std::vector<SlopeColumn>& columns,
                        std::span<double> out);

}  // namespace mariotte::study
