// Columns of a sweep that are slopes: "sensitivity.OUTCOME.PARAMETER", as "sensitivity.velocity[2].mass[0]"
// or "sensitivity.time.contact[1].stiffness", by the names of `mariotte sensitivity`.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/scene/scene.hpp"

namespace mariotte::study {

/// The slope of one outcome by one number of the model.
struct SlopeColumn {
  std::size_t column;  ///< its number among all
  std::string outcome, parameter;
};

bool is_slope(std::string_view key);

/// Throws ColumnError if this model has no such outcome, or no such parameter.
void expect_slope(const std::string& key, const scene::Scene& scene);

/// That of the outcome by that of the parameter, "kg^-1 m s^-1"; "SI" where one of them is not known.
std::string unit_of_slope(const std::string& key, const scene::Scene& scene);

/// Of a key that is a slope.
SlopeColumn slope_column(std::string_view key, std::size_t column);

/// Fills in the slopes of a chain or a network by one run with slopes, nan where there is none; of other
/// models all are nan.
void fill_slopes(const scene::Scene& scene, const std::vector<SlopeColumn>& columns, std::span<double> out);

}  // namespace mariotte::study
