#include "mariotte/report/csv/csv_metadata.hpp"

#include "mariotte/report/csv/csv_cell.hpp"
#include "mariotte/report/csv/sweep_csv.hpp"

namespace mariotte::report {
namespace {

/// Of "v5 [m/s]", a column of samples.
Json column(const std::string& title, std::span<const impact::Description> known) {
  const auto name = key_of_column(title);
  Json made = {{"titles", title}, {"name", name}, {"datatype", "number"}};
  if (title.ends_with(']')) made["schema:unitText"] = unit_of_column(title);
  const auto symbol = name.substr(0, name.find_first_of("0123456789"));
  for (const auto& is : known)
    if (is.symbol == symbol || is.key == symbol) made["dc:description"] = is.meaning;
  return made;
}

}  // namespace

std::filesystem::path metadata_name(const std::filesystem::path& csv) {
  auto name = csv;
  return name += "-metadata.json";
}

std::string trace_metadata(const std::string& file, const std::string& header, const Attributes& origin,
                           std::span<const impact::Description> known) {
  std::vector<std::string> titles;
  split(std::string_view(header).substr(0, header.find('\n')), titles);
  auto columns = Json::array(), notes = Json::array();
  for (const auto& title : titles) columns.push_back(column(title, known));
  auto& note = notes.emplace_back(Json::object());
  for (const auto& [name, words] : origin) note[name] = words;
  return text({{"@context", "http://www.w3.org/ns/csvw"},
               {"url", file},
               {"tableSchema", {{"columns", columns}}},
               {"notes", notes}});
}

}  // namespace mariotte::report
