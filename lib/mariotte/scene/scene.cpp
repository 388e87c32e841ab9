#include "mariotte/scene/scene.hpp"

#include <array>

#include "mariotte/scene/chain_reader.hpp"
#include "mariotte/scene/document.hpp"
#include "mariotte/scene/overrides.hpp"
#include "mariotte/scene/run_reader.hpp"
#include "mariotte/scene/sha256.hpp"
#include "mariotte/scene/sweep_shape.hpp"
#include "mariotte/scene/text_file.hpp"
#include "mariotte/scene/toml.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 9> keys{"title", "chain", "run",     "sweep",    "columns",
                                               "law",   "body",  "surface", "incidence"};

/// The digest of the text alone is that of the file; a zero byte, which no scene holds, sets off each
/// override.
std::string fingerprint(const std::string& text, const Overrides& overrides) {
  std::string all = text;
  for (const auto& override : overrides) (all += '\0') += override;
  return sha256(all);
}

void expect_chain_scene(const Source& source, const Field& root) {
  expect_keys(source, root, keys);
  for (const auto* key : {"body", "surface", "incidence"})
    if (const auto field = find(root, key))
      reject(source, *field,
             "scenes of a body on a surface are not supported by this version, only [chain] scenes");
}

/// What is to be simulated needs a chain, and a law needs the masses of one or its own.
bool has_chain(const Source& source, const Field& root, const std::optional<Law>& law, Purpose purpose) {
  if (find(root, "chain")) return true;
  if (purpose == Purpose::simulation || !law || law->mass.empty())
    reject(source, root.place(), "the scene has no [chain]");
  return false;
}

Scene read_scene(Source& source, const Field& root, Purpose purpose) {
  expect_chain_scene(source, root);
  Scene scene;
  std::optional<Field> gravity;
  if (const auto title = find(root, "title")) scene.title = text(source, *title);
  if (const auto run = find(root, "run")) {
    scene.run = read_run(source, *run);
    gravity = find(*run, "gravity");
  }
  if (const auto sweeps = find(root, "sweep")) expect_sweeps(source, *sweeps);
  if (const auto columns = find(root, "columns")) expect_columns(source, *columns);
  if (const auto law = find(root, "law")) scene.law = read_law(source, *law);
  if (!has_chain(source, root, scene.law, purpose)) return scene;
  const auto chain = *find(root, "chain");
  auto resolved = read_chain(source, chain, gravity);
  scene.chain = std::move(resolved.chain);
  scene.radius = std::move(resolved.radius);
  return scene;
}

/// Whatever the reader let through, the model has the last word on what can be simulated.
void expect_valid(const Source& source, const Field& root, const model::Chain& chain) {
  try {
    model::validate(chain);
  } catch (const InvalidParameter& error) {
    reject(source, *find(root, "chain"), error.what());
  }
}

}  // namespace

Document parse_document(const std::string& text, const std::string& name, const Overrides& overrides) {
  Document document{.source = {.name = name, .set_keys = {}}, .tree = {}, .sha256 = {}};
  document.tree = parse_toml(document.source, text);
  apply(overrides, document.source, document.tree);
  document.sha256 = fingerprint(text, overrides);
  return document;
}

Document open(const std::string& path, const Overrides& overrides) {
  return parse_document(read_text(path), path, overrides);
}

Scene resolve(const Document& document, Purpose purpose, Watch* watch) {
  Source source = document.source;
  source.watch = watch;
  const Field root{&document.tree, ""};
  Scene scene = read_scene(source, root, purpose);
  if (!scene.chain.mass.empty()) expect_valid(source, root, scene.chain);
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
