// What was measured, as the user wrote it into a table.
//
//     speed [m/s], diameter [um], restitution, deviation
//     5,           4.9,           0.866,       0.01
//
// A column is named by a key of the scene, which the rows then set, or by one of the words below. A unit
// may follow in the header, or stand in the cells.
//
//     speed                            incidence.normal_speed; of a chain, chain.velocity[0]
//     diameter                         body.diameter, or chain.diameter; half of it is the radius where the
//                                      scene gives that
//     restitution                      of the tip of a body, or of the two balls of a chain, measured
//     any key of a result              measured, as restitution.centre or contacts[0].peak_force
//     deviation                        standard deviation of what was measured; optional
//     ending, reason                   left out: the table may come from a sweep
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/scene/node.hpp"

namespace mariotte::study {

/// A column whose values are put into the scene.
struct Setting {
  std::string name;  ///< as the header says
  std::string key;
  std::string unit = {};    ///< SI, where the scene reads a number: "1" of a pure one
  scene::Place place = {};  ///< in the header
};

/// One row: what it puts into the scene, and what was measured there.
struct Measurement {
  scene::Place place;
  std::vector<std::string> written;  ///< a text per setting, with its unit
  std::vector<scene::Node> values;   ///< the same, as the scene reads it
  double measured = 0;
  double deviation = 1;  ///< > 0; only its ratios count
};

struct Measurements {
  std::string file;
  std::vector<Setting> settings;         ///< at least one
  std::string quantity = "restitution";  ///< that was measured: a key of the result
  scene::Place quantity_place;           ///< of its column, in the header
  std::string unit = "1";                ///< of what was measured, as a column of a sweep has it
  std::string_view symbol = {};          ///< of the same; empty of a restitution
  bool weighted = false;                 ///< deviations are given
  std::vector<Measurement> rows;
};

/// Reads a table. Throws scene::SceneError, or scene::FileError if there is none.
Measurements read_measurements(const std::string& path);
Measurements parse_measurements(const std::string& text, const std::string& name);

}  // namespace mariotte::study
