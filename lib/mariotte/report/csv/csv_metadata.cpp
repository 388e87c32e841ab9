#include "mariotte/report/csv/csv_metadata.hpp"

#include <algorithm>

#include "mariotte/impact/quantities/description.hpp"
#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/csv/sweep_csv.hpp"

namespace mariotte::report {
namespace {

/// Of "v5 [m/s]".
Json column(const std::string& title) {
  const auto name = key_of_column(title);
  const auto is_named = [symbol = name.substr(0, name.find_first_of("0123456789"))](const auto& is) {
    return is.symbol == symbol || is.key == symbol;
  };
  const auto& is = *std::find_if(impact::sampled.begin(), impact::sampled.end(), is_named);
  return {{"titles", title},
          {"name", name},
          {"datatype", "number"},
          {"schema:unitText", is.unit},
          {"dc:description", is.meaning}};
}

}  // namespace

std::filesystem::path metadata_name(const std::filesystem::path& csv) {
  auto name = csv;
  return name += "-metadata.json";
}

std::string trace_metadata(const std::string& file, const std::string& header, const Attributes& origin) {
  std::vector<std::string> titles;
  split(std::string_view(header).substr(0, header.find('\n')), titles);
  auto columns = Json::array(), notes = Json::array();
  for (const auto& title : titles) columns.push_back(column(title));
  auto& note = notes.emplace_back(Json::object());
  for (const auto& [name, words] : origin) note[name] = words;
  return text({{"@context", "http://www.w3.org/ns/csvw"},
               {"url", file},
               {"tableSchema", {{"columns", columns}}},
               {"notes", notes}});
}

}  // namespace mariotte::report
