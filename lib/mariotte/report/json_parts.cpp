#include "mariotte/report/json_parts.hpp"

#include "mariotte/report/provenance.hpp"

namespace mariotte::report {

Json from_one(const std::vector<Index>& positions) {
  return list(positions, [](Index position) { return position + 1; });
}

Json flow(const impact::FlowUse& use) {
  return {{"name", use.name}, {"phases", use.phases}, {"steps", use.steps}, {"rhs", use.rhs}};
}

Json skipped(const std::vector<impact::Skipped>& skipped) {
  Json object = Json::object();
  for (const auto& one : skipped) object[one.what] = one.why;
  return object;
}

Json options(const hybrid::Options& run) {
  return {{"accuracy", run.accuracy},
          {"max_time", run.max_time},
          {"max_events", run.max_events},
          {"flow", run.flow}};
}

Json provenance_json(const std::string& scene_sha256) {
  const auto program = provenance();
  return {{"version", program.version},
          {"scene_sha256", scene_sha256.empty() ? Json(nullptr) : Json(scene_sha256)},
          {"sundials", program.sundials},
          {"compiler", program.compiler},
          {"build_type", program.build_type}};
}

}  // namespace mariotte::report
