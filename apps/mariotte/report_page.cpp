#include "report_page.hpp"

#include <algorithm>

#include "mariotte/report/files.hpp"
#include "mariotte/report/html.hpp"
#include "mariotte/scene/text_file.hpp"

namespace mariotte::command {
namespace {

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

void write_report_page(const std::filesystem::path& folder, const report::Json& result) {
  report::write_file(folder / report_page, report::html(result, pictures(folder)));
}

}  // namespace mariotte::command
