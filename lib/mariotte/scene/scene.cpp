#include "mariotte/scene/scene.hpp"

#include <algorithm>
#include <array>

#include "mariotte/core/overload.hpp"
#include "mariotte/scene/document.hpp"
#include "mariotte/scene/error_list.hpp"
#include "mariotte/scene/figure_reader.hpp"
#include "mariotte/scene/fingerprint.hpp"
#include "mariotte/scene/law_reader.hpp"
#include "mariotte/scene/model_reader.hpp"
#include "mariotte/scene/overrides.hpp"
#include "mariotte/scene/run_reader.hpp"
#include "mariotte/scene/sweep_shape.hpp"
#include "mariotte/scene/text_file.hpp"
#include "mariotte/scene/toml.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 12> scene_keys{"title", "chain",   "network",   "bodies",
                                                      "run",   "sweep",   "columns",   "law",
                                                      "body",  "surface", "incidence", "figure"};

/// Events of a wave through the model: the limit is for what does not end.
Index events_of_wave(const Model& model) {
  return std::visit(
      Overload{[](const model::Chain& chain) { return 10 * std::ssize(chain.mass); },
               [](const model::Network&) { return Index{0}; },
               [](const model::Microbody&) { return Index{0}; },
               [](const model::Bodies&) { return Index{0}; }, [](const LawAlone&) { return Index{0}; }},
      model);
}

/// It heads tables, figures and pages, in one line.
std::string read_title(const Source& source, const Field& title) {
  constexpr std::size_t longest = 1000;
  auto words = text(source, title);
  if (words.size() > longest)
    reject(source, title, fault::out_of_range, "has more than " + std::to_string(longest) + " bytes");
  return words;
}

Scene read_scene(Source& source, const Field& root, Purpose purpose) {
  expect_one_model(source, root, purpose);
  Scene scene;
  ErrorList errors;
  const auto part = [&](const char* key, auto&& read) {
    if (const auto field = find(root, key)) errors.attempt([&] { read(*field); });
  };
  errors.attempt([&] { expect_keys(source, root, scene_keys); });
  part("title", [&](const Field& title) { scene.title = read_title(source, title); });
  const auto run = find(root, "run");
  part("run", [&](const Field& field) {
    scene.run = read_run(source, field, find(root, "body").has_value());
    scene.until = find(field, "until").has_value();
  });
  part("figure", [&](const Field& figure) { scene.figure = read_figure(source, figure); });
  part("sweep", [&](const Field& sweeps) { expect_sweeps(source, sweeps); });
  part("columns", [&](const Field& columns) { expect_columns(source, columns); });
  part("law", [&](const Field& law) { scene.law = read_law(source, law); });
  errors.attempt([&] {
    auto resolved = read_model(source, root, scene.law, purpose);
    scene.model = std::move(resolved.model);
    scene.radius = std::move(resolved.radius);
    scene.touching = std::move(resolved.touching);
    scene.ball = std::move(resolved.ball);
    scene.reach = resolved.reach;
  });
  errors.raise();
  if (!run || !find(*run, "max_events"))
    scene.run.max_events = std::max(scene.run.max_events, events_of_wave(scene.model));
  return scene;
}

}  // namespace

void refuse(const LawAlone&) {
  throw SceneError(no_model, fault::no_model);
}

Document parse_document(const std::string& text, const std::string& name, const Overrides& overrides) {
  Document document{.source = {.name = name, .origins = {}}, .tree = {}, .sha256 = {}};
  document.tree = parse_toml(document.source, text);
  apply(overrides, document.source, document.tree);
  document.sha256 = fingerprint(text, overrides, document.source, document.tree);
  return document;
}

Document open(const std::string& path, const Overrides& overrides) {
  return parse_document(read_text(path), path, overrides);
}

Scene resolve(const Document& document, Purpose purpose, ReadingLog* watch) {
  Source source = document.source;
  source.watch = watch;
  const Field root{&document.tree, ""};
  Scene scene = read_scene(source, root, purpose);
  scene.warnings = std::move(source.warnings);
  scene.sha256 = document.sha256;
  return scene;
}

Scene parse(const std::string& text, const std::string& name, const Overrides& overrides, Purpose purpose) {
  return resolve(parse_document(text, name, overrides), purpose);
}

Scene read(const std::string& path, const Overrides& overrides, Purpose purpose) {
  return resolve(open(path, overrides), purpose);
}

}  // namespace mariotte::scene
