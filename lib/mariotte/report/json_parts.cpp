#include "mariotte/report/json_parts.hpp"

#include "mariotte/report/provenance.hpp"

namespace mariotte::report {

Json provenance_json(const std::string& scene_sha256) {
  const auto program = provenance();
  return {{"version", program.version},
          {"scene_sha256", scene_sha256.empty() ? Json(nullptr) : Json(scene_sha256)},
          {"sundials", program.sundials},
          {"compiler", program.compiler},
          {"build_type", program.build_type}};
}

}  // namespace mariotte::report
