// What `mariotte law` says of bodies with friction.
#pragma once
#include <string>

#include "mariotte/impact/bodies/first_impact.hpp"
#include "mariotte/report/json/json.hpp"

namespace mariotte::report {

/// Laws beside the first impact of a scene.
struct FrictionLawReport {
  std::string title;
  impact::FirstImpact impact;
  std::string scene_sha256 = {};
};

Json json(const FrictionLawReport& report);
std::string table(const FrictionLawReport& report);

}  // namespace mariotte::report
