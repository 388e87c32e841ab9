#include "output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/figure/gnuplot.hpp"
#include "mariotte/report/number.hpp"
#include "mariotte/report/page/files.hpp"
#include "picture.hpp"

namespace mariotte::paper_figures {
namespace {

const char* word(Verdict verdict) {
  switch (verdict) {
    case Verdict::yes:
      return "true";
    case Verdict::partly:
      return "partly";
    case Verdict::no:
      return "false";
  }
  return "";
}

std::string table(const std::vector<Check>& checks) {
  const auto row = [&](Index i) -> report::TableRow {
    const auto& one = checks[static_cast<std::size_t>(i)];
    return {one.what,
            fmt::format("{:.12g}", one.computed),
            fmt::format("{:.12g}", one.expected),
            fmt::format("{:.1e}", std::abs(one.computed - one.expected)),
            fmt::format("{:.0e}", one.allowed),
            holds(one) ? "pass" : "FAIL"};
  };
  return report::columns({"quantity", "computed", "expected", "difference", "allowed", ""},
                         std::ssize(checks), row);
}

std::string claims(const Reproduction& result) {
  std::string text;
  for (const auto& claim : result.claims)
    text += fmt::format("  {}: {} ({})\n", word(claim.verdict), claim.text, claim.finding);
  if (!result.remark.empty()) text += fmt::format("  {}\n", result.remark);
  return text;
}

std::string checks_csv(const Reproduction& result) {
  std::string text = "quantity,computed,expected,allowed,holds\n";
  for (const auto& one : result.checks)
    text += fmt::format("\"{}\",{},{},{},{}\n", one.what, report::exact(one.computed),
                        report::exact(one.expected), report::exact(one.allowed), holds(one));
  return text;
}

}  // namespace

std::string details(const Figure& figure, const Reproduction& result) {
  return fmt::format("{}: {}\n{}{}", figure.name, figure.title, table(result.checks), claims(result));
}

std::string summary(const Figure& figure, const Reproduction& result) {
  std::vector<Check> failed;
  std::copy_if(result.checks.begin(), result.checks.end(), std::back_inserter(failed),
               [](const Check& one) { return !holds(one); });
  const auto all = result.checks.size();
  return fmt::format("{}: {} · {} of {} checks pass\n{}{}", figure.name, figure.title, all - failed.size(),
                     all, failed.empty() ? "" : table(failed), claims(result));
}

std::vector<std::string> file_names(const Figure& figure) {
  auto names = report::files_of_figure(figure.name);
  names.insert(names.end(), {"plot.csv", "plot.gp", "checks.csv"});
  return names;
}

std::string write(const std::filesystem::path& folder, const Figure& figure, const Reproduction& result) {
  report::write_file(folder / "plot.csv", plot_data(result.picture));
  report::write_file(folder / "plot.gp", plot_script(result.picture, figure.name));
  report::write_file(folder / "checks.csv", checks_csv(result));
  return report::draw(folder, report::files_of_figure(figure.name));
}

}  // namespace mariotte::paper_figures
