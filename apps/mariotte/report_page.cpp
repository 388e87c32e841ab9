#include "report_page.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>

#include "mariotte/report/json/sweep_json.hpp"
#include "mariotte/report/page/files.hpp"
#include "mariotte/report/page/html.hpp"
#include "mariotte/scene/text_file.hpp"

namespace mariotte::command {
namespace {

constexpr std::size_t most_bytes = -1;  // results of long chains have no limit

report::Json read_object(const std::filesystem::path& path) {
  auto object = report::Json::parse(scene::read_text(path.string(), most_bytes), nullptr, false);
  if (!object.is_object()) throw scene::FileError(path.string() + ": holds no result");
  return object;
}

std::vector<report::Picture> pictures(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".svg") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<report::Picture> all;
  for (const auto& path : paths) all.push_back({path.stem().string(), scene::read_text(path.string())});
  return all;
}

}  // namespace

report::Json read_result(const std::filesystem::path& folder) {
  const auto has = [&](const char* name) { return std::filesystem::exists(folder / name); };
  if (!has("sweep.json") && !has("result.json"))
    throw scene::FileError(folder.string() +
                           (has("journal.jsonl") ? ": its sweep is not finished; run it again, and it goes on"
                                                 : ": no run or sweep has left its result here"));
  if (!has("sweep.json")) {
    auto result = read_object(folder / "result.json");
    if (result.contains("derivative"))
      throw scene::FileError(folder.string() +
                             ": holds slopes, which have no page: see slopes.csv and tornado.svg");
    return result;
  }
  auto result = read_object(folder / "sweep.json");
  std::ifstream csv(folder / "sweep.csv");
  if (!csv) throw scene::FileError((folder / "sweep.csv").string() + ": cannot be read");
  result.update(report::summary(csv));
  return result;
}

void write_report_page(const std::filesystem::path& folder, const report::Json& result) {
  const auto moving = folder / motion_file;
  const auto motion = std::filesystem::exists(moving) ? read_object(moving) : report::Json();
  report::write_file(folder / report_page, report::html(result, pictures(folder), motion));
}

}  // namespace mariotte::command
