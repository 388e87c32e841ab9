#include "mariotte/report/text.hpp"

#include <nlohmann/json.hpp>

#include "mariotte/report/csv/csv.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/json/json_stream.hpp"
#include "mariotte/report/table/table.hpp"

namespace mariotte::report {

std::string json_text(const scene::Impact& impact, const scene::Scene& scene) {
  std::string all;
  JsonStream stream([&](std::string_view piece) { all += piece; });
  std::visit([&](const auto& one) { write(stream, one, scene); }, impact);
  return all;
}

std::string table_text(const scene::Impact& impact, const scene::Scene& scene, Detail detail) {
  return std::visit([&](const auto& one) { return table(one, scene, detail); }, impact);
}

std::string events_text(const scene::Impact& impact) {
  return std::visit([](const auto& one) { return events_csv(one); }, impact);
}

std::string trace_text(const scene::Impact& impact) {
  return std::visit([](const auto& one) { return trace_csv(one); }, impact);
}

}  // namespace mariotte::report
