#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.hpp"
#include "command_line/exit_code.hpp"
#include "command_line/terminal.hpp"
#include "command_line/values.hpp"
#include "mariotte/report/csv/columns.hpp"
#include "mariotte/report/json/json.hpp"
#include "mariotte/report/table/law_name.hpp"
#include "mariotte/study/capture.hpp"
#include "mariotte/study/pair_choice.hpp"
#include "run_notes.hpp"
#include "scene_choice.hpp"

namespace mariotte::command {
namespace {

struct Curve {
  SceneChoice scene;
  std::string from, to;
  int count = 21;
  bool json = false;
};

struct Point {
  double speed, restitution;
  std::optional<double> closed_form;
};

std::vector<double> speeds(const Curve& curve) {
  const double from = positive_quantity("--from", curve.from, dimension::velocity);
  const double to = positive_quantity("--to", curve.to, dimension::velocity);
  std::vector<double> all = {from};
  for (int i = 1; i < curve.count; ++i)
    all.push_back(from * std::pow(to / from, static_cast<double>(i) / (curve.count - 1)));
  return all;
}

std::vector<Point> points(const std::vector<double>& speeds, const impact::Pair& pair) {
  std::vector<Point> all;
  for (const double speed : speeds)
    all.push_back({speed, impact::restitution(pair, speed), impact::closed_restitution(pair, speed)});
  return all;
}

std::string table(const std::vector<Point>& curve, const scene::Scene& scene, const impact::Pair& pair) {
  const auto row = [&](Index i) -> report::TableRow {
    const auto& [speed, e, closed] = curve[static_cast<std::size_t>(i)];
    return {fmt::format("{:.6g}", speed), fmt::format("{:.12f}", e),
            closed ? fmt::format("{:.12f}", *closed) : "–"};
  };
  return fmt::format("{}\nRestitution of a pair with the law {}, reduced mass {:.10g} kg\n",
                     scene.title.empty() ? "Chain" : scene.title, report::law_name(pair.law),
                     pair.reduced_mass) +
         report::columns({"speed [m/s]", "restitution e", "in closed form"}, std::ssize(curve), row);
}

report::Json json(const std::vector<Point>& curve, const scene::Scene& scene, const impact::Pair& pair) {
  report::Json result = {{"title", scene.title},
                         {"law", name(pair.law)},
                         {"reduced_mass", pair.reduced_mass},
                         {"curve", report::Json::array()}};
  for (const auto& [speed, e, closed] : curve) {
    result["curve"].push_back({{"speed", speed}, {"restitution", e}, {"closed_form", nullptr}});
    if (closed) result["curve"].back()["closed_form"] = *closed;
  }
  return result;
}

int restitution(const Curve& options) {
  const auto document = open(options.scene);
  const auto scene = resolve(options.scene, document);
  const auto pair = study::pair_of(scene, options.scene.path, "followed at other speeds");
  const auto at = speeds(options);
  const auto curve = points(at, pair);
  print(options.json ? report::text(json(curve, scene, pair)) : table(curve, scene, pair));
  const double fastest = std::max(at.front(), at.back());  // it goes deepest
  return tell_run_at(fastest, study::at_speed(document, fastest), options.scene.quiet);
}

constexpr const char* restitution_examples = R"(Examples:
  mariotte restitution steel_pair.toml --from 0.01 --to 10
  mariotte restitution fine_powder.toml --from "5 cm/s" --to 2 --count 50 --json

The contact of two bodies alone, at speeds whose logarithms are evenly spaced; 0 where adhesion keeps them.
)";

}  // namespace

Command restitution_command() {
  auto options = std::make_shared<Curve>();
  return {
      .name = "restitution",
      .about = "Show how the restitution of two bodies depends on their speed",
      .footer = restitution_examples,
      .options = joined(
          {scene_options(options->scene),
           {{"--from", &options->from, "Smallest speed [m/s]", {.value = "SPEED", .required = true}},
            {"--to", &options->to, "Largest speed [m/s]", {.value = "SPEED", .required = true}},
            {"--count", &options->count, "How many speeds", {.check = Range{1, 1e6}, .shows_default = true}},
            {"--json", &options->json, "One JSON object on stdout"}}}),
      .act = [options] { return restitution(*options); }};
}

}  // namespace mariotte::command
