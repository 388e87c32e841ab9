#include <memory>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "mariotte/report/page/files.hpp"
#include "report_page.hpp"

namespace mariotte::command {
namespace {

struct Report {
  std::string folder;
  bool force = false;
};

int report(const Report& options) {
  const auto result = read_result(options.folder);
  report::prepare_folder(options.folder, {report_page}, options.force);
  write_report_page(options.folder, result);
  print((std::filesystem::path(options.folder) / report_page).string() + "\n");
  return ExitCode::ok;
}

constexpr const char* report_examples = R"(Examples:
  mariotte run cradle.toml --out results && mariotte report results
  mariotte run cradle.toml --out results --report
  mariotte sweep map.toml --out map && mariotte report map

Writes report.html: outcome and checks, figures, tables, provenance, the command that repeats it, and what to
cite, all in one file.
)";

}  // namespace

Command report_command() {
  auto options = std::make_shared<Report>();
  return {.name = "report",
          .about = "Make one page of the files of a run or a sweep",
          .footer = report_examples,
          .options = {{"DIR",
                       &options->folder,
                       "Folder that `run --out` or `sweep --out` has filled",
                       {.required = true}},
                      {"--force", &options->force, "Overwrite an earlier page"}},
          .act = [options] { return report(*options); }};
}

}  // namespace mariotte::command
