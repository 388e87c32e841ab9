#include "mariotte/report/page/html.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "mariotte/report/page/animation.hpp"
#include "mariotte/report/page/before_and_after.hpp"
#include "mariotte/report/page/copied_digits.hpp"
#include "mariotte/report/page/html_table.hpp"
#include "mariotte/report/page/html_text.hpp"
#include "mariotte/report/page/lead.hpp"

namespace mariotte::report {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --line: #8884; --soft: #8882; }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; max-width: 78rem; padding: 1rem clamp(.25rem, 2vw, 1rem); }
h1 { font-size: 1.6rem; margin: .5rem 0; }
h2 { font-size: 1.2rem; border-bottom: 1px solid var(--line); margin: 2rem 0 .5rem; }
h3 { font-size: 1rem; margin: 1rem 0 .25rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
sub { line-height: 0; }
th, td { border-bottom: 1px solid var(--soft); padding: .15rem .75rem .15rem 0; text-align: left; }
td.n { text-align: right; white-space: nowrap; }
.lead { font-size: 1.15rem; }
.figures { display: grid; gap: .5rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 23rem), 1fr)); }
.figures p { margin: 0; }
.figures img { background: white; display: block; height: auto; width: 100%; }
.moving { margin: 0; }
.moving canvas { display: block; touch-action: none; width: 100%; }
.moving div { align-items: center; display: flex; gap: .75rem; }
.moving input { flex: 1; min-width: 4rem; }
.moving output { font-variant-numeric: tabular-nums; min-width: 8.5rem; }
.moving button { font: inherit; min-width: 5rem; padding: .25rem .75rem; }
pre { background: var(--soft); overflow-x: auto; padding: .75rem; }
.checks { display: grid; gap: .5rem; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); }
.checks div { background: var(--soft); padding: .5rem .75rem; }
.checks b { display: block; font-size: 1.15rem; overflow-wrap: anywhere; }
)";

/// Parts of a result in the order of their interest; what is not among them comes after them.
constexpr std::array<std::array<const char*, 2>, 23> sections{
    {{"warnings", "Warnings"},
     {"final", "Final state"},
     {"restitution", "Restitution"},
     {"impacts", "Impacts"},
     {"contacts", "Contacts"},
     {"icr", "Impulse correlation ratios"},
     {"impulse_direction", "Impulse direction"},
     {"events", "Events"},
     {"energy", "Energy"},
     {"momentum", "Momentum"},
     {"bound_frequency", "What rings on"},
     {"rest", "Where it comes to rest"},
     {"shared_friction", "Two tips stuck at once and shared the least friction"},
     {"turning", "Neglected: turning of contact directions [rad]"},
     {"validity", "Validity"},
     {"flows", "Flows"},
     {"skipped", "Not needed"},
     {"accuracy", "Accuracy"},
     {"varied", "What is varied"},
     {"derived", "What follows from it"},
     {"columns", "Columns"},
     {"endings", "Endings"},
     {"reasons", "Why points have no numbers or ended at a limit"}}};
const std::set<std::string> elsewhere = {"ending", "title",  "model", "message",    "provenance",
                                         "points", "failed", "scene", "scene_text", "statistics"};

constexpr const char* citations = R"(@software{mariotte,
  title   = {mariotte: a solver for stiff, event-driven impacts},
  version = {@version},
  note    = {scene @scene}
}
)";
constexpr const char* of_contacts = R"(@inproceedings{acary2003,
  author    = {Acary, Vincent and Brogliato, Bernard},
  title     = {Toward a multiple impact law: the 3-ball chain example},
  booktitle = {Second MIT Conference on Computational Fluid and Solid Mechanics},
  year      = {2003}
}
)";
constexpr const char* of_bodies = R"(@article{cheng2002,
  author  = {Cheng, W. and Brach, R. M. and Dunn, P. F.},
  title   = {Shape Effects on Microbody Impacts against a Flat Surface},
  journal = {Aerosol Science and Technology},
  year    = {2002}
}
)";

std::string section(const std::string& title, const std::string& content) {
  return "<h2>" + escaped(title) + "</h2>\n" + content;
}

std::string card(const char* name, const std::string& value) {
  return fmt::format("<div>{}<b>{}</b></div>\n", name, escaped(value));
}

std::string two_digits(const Json& value) {
  return value.is_number() ? fmt::format("{:.1e}", value.get<double>()) : inline_text(value);
}

/// A residual, as a share of what was there before where that is not zero.
std::string residual(const Json& balance, const std::string& unit) {
  const double scale = std::abs(balance.value("initial", 0.0)),
               rest = std::abs(balance.value("residual", 0.0));
  return scale > 0 ? two_digits(rest / scale) + " of the initial" : two_digits(rest) + " " + unit;
}

std::string checks(const Json& result) {
  std::string cards;
  if (result.contains("points")) cards += card("points", inline_text(result["points"]));
  if (result.contains("failed")) cards += card("without a result", inline_text(result["failed"]));
  if (result.contains("ending")) cards += card("ending", inline_text(result["ending"]));
  if (result.contains("final") && result["final"].contains("time"))
    cards += card("final time", quantity(result["final"]["time"].get<double>(), "s"));
  if (result.contains("accuracy")) {
    cards += card("accuracy asked for", inline_text(result["accuracy"].value("requested", Json())));
    cards += card("accuracy estimated", two_digits(result["accuracy"].value("estimated", Json())));
  }
  for (const auto& [balance, unit] : {std::pair{"energy", "J"}, {"momentum", "N s"}})
    if (result.contains(balance) && result[balance].is_object() && result[balance].contains("residual"))
      cards += card(fmt::format("{} balance residual", balance).c_str(), residual(result[balance], unit));
  return "<div class=\"checks\">\n" + cards + "</div>\n";
}

std::string figures(const std::vector<Picture>& pictures) {
  std::string text;
  for (const auto& [name, svg] : pictures)
    text += fmt::format("<p><img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\"></p>\n", escaped(name),
                        base64(svg));
  return text.empty() ? "" : section("Figures", "<div class=\"figures\">\n" + text + "</div>\n");
}

std::string tables(const Json& result) {
  std::string text;
  const auto model = result.value("model", "");
  std::set<std::string> done = elsewhere;
  for (const auto& [key, title] : sections)
    if (done.insert(key).second && result.contains(key) && !result[key].empty() && result[key] != Json(false))
      text += section(title, table(result[key], {model, key}));
  for (const auto& [key, value] : result.items())
    if (!done.contains(key) && !value.empty()) text += section(key, table(value, {model, key}));
  return text;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  return text.replace(text.find(what), what.size(), by);
}

std::string origin(const Json& result) {
  const auto provenance = result.value("provenance", Json::object());
  std::string text = section("Provenance", table(provenance));
  if (const auto scene = result.value("scene_text", ""); !scene.empty())
    text += section("Scene file", "<pre>" + escaped(scene) + "</pre>\n");
  if (const auto command = repeating_command(result); !command.empty())
    text += section("Again", "<pre>" + escaped(command) + "</pre>\n");
  return text + section("To cite", "<pre>" + escaped(to_cite(result)) + "</pre>\n");
}

std::string shell_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + "'";
}

}  // namespace

std::string to_cite(const Json& result) {
  const auto provenance = result.value("provenance", Json::object());
  const auto version = inline_text(provenance.value("version", Json("unknown")));
  const auto scene = inline_text(provenance.value("scene_sha256", Json()));
  const auto software = replaced(replaced(citations, "@version", version), "@scene", scene);
  const auto model = result.value("model", "");
  const auto* paper = model == "microbody" ? of_bodies : model.empty() ? "" : of_contacts;
  return software + paper;
}

std::string repeating_command(const Json& result) {
  const auto provenance = result.value("provenance", Json::object());
  const bool is_of_python = provenance.contains("run");
  if (!provenance.contains("scene") || is_of_python) return "";
  const auto scene = shell_quoted(inline_text(provenance["scene"]));
  const bool is_sweep = provenance.contains("columns");
  auto command = is_sweep ? "mariotte sweep " + scene + " --out again" : "mariotte run " + scene;
  for (const auto& override : provenance.value("overrides", Json::array()))
    command += " --set " + shell_quoted(inline_text(override));
  for (const auto& column : provenance.value("columns", Json::array()))
    command += " --column " + shell_quoted(inline_text(column));
  return command;
}

std::string html(const Json& result, const std::vector<Picture>& pictures, const Json& motion) {
  const auto title = result.value("title", "");
  const auto name = escaped(title.empty() ? "Impact" : title);
  std::string page =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n";
  page +=
      fmt::format("<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n<h1>{}</h1>\n", name, style, name);
  page += lead(result) + checks(result);
  if (result.contains("message")) page += "<p>" + escaped(inline_text(result["message"])) + "</p>\n";
  return page + animation(motion, result) + figures(pictures) + before_and_after(result) + tables(result) +
         origin(result) + copied_digits + "</body>\n</html>\n";
}

}  // namespace mariotte::report
