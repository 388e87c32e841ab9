#include "mariotte/report/text.hpp"

#include <nlohmann/json.hpp>

#include "mariotte/report/csv/csv.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/table/table.hpp"

namespace mariotte::report {

std::string json_text(const scene::Impact& impact, const scene::Scene& scene) {
  return std::visit([&](const auto& one) { return text(json(one, scene)); }, impact);
}

std::string table_text(const scene::Impact& impact, const scene::Scene& scene) {
  return std::visit([&](const auto& one) { return table(one, scene); }, impact);
}

std::string events_text(const scene::Impact& impact) {
  return std::visit([](const auto& one) { return events_csv(one); }, impact);
}

std::string trace_text(const scene::Impact& impact) {
  return std::visit([](const auto& one) { return trace_csv(one); }, impact);
}

}  // namespace mariotte::report
