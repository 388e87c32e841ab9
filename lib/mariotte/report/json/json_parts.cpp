#include "mariotte/report/json/json_parts.hpp"

#include "mariotte/report/page/provenance.hpp"

namespace mariotte::report {

Json json_of_value(const scene::Node& node) {
  if (const auto* real = std::get_if<double>(&node.value)) return *real;
  if (const auto* integer = std::get_if<std::int64_t>(&node.value)) return *integer;
  if (const auto* truth = std::get_if<bool>(&node.value)) return *truth;
  if (const auto* words = std::get_if<std::string>(&node.value)) return *words;
  return nullptr;
}

Json options(const hybrid::Options& run) {
  return {{"accuracy", run.accuracy},
          {"max_time", run.max_time},
          {"max_events", run.max_events},
          {"flow", flow::name(run.flow)}};
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
