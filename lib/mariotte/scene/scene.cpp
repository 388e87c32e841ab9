#include "mariotte/scene/scene.hpp"

#include <algorithm>
#include <array>

#include "mariotte/model/representable.hpp"
#include "mariotte/scene/body_reader.hpp"
#include "mariotte/scene/chain_reader.hpp"
#include "mariotte/scene/document.hpp"
#include "mariotte/scene/network_reader.hpp"
#include "mariotte/scene/overrides.hpp"
#include "mariotte/scene/run_reader.hpp"
#include "mariotte/scene/sha256.hpp"
#include "mariotte/scene/sweep_shape.hpp"
#include "mariotte/scene/text_file.hpp"
#include "mariotte/scene/toml.hpp"

namespace mariotte::scene {
namespace {

constexpr std::array<std::string_view, 10> keys{"title",   "chain", "network", "run",     "sweep",
                                                "columns", "law",   "body",    "surface", "incidence"};

/// The digest of the text alone is that of the file; a zero byte, which no scene holds, sets off each
/// override.
std::string fingerprint(const std::string& text, const Overrides& overrides) {
  std::string all = text;
  for (const auto& override : overrides) (all += '\0') += override;
  return sha256(all);
}

/// True of a body, false of a chain, of a network or of a law.
bool is_body_scene(const Source& source, const Field& root, Purpose purpose) {
  if (const auto body = find(root, "body")) {
    for (const auto* key : {"chain", "network", "law"})
      if (const auto field = find(root, key))
        reject(source, *field, fault::contradiction,
               "a scene has a [body] or a [" + std::string(key) + "], not both");
    if (purpose == Purpose::law)
      reject(source, *body, fault::no_model, "the multiple-impact law needs a [chain] or [network]");
    return true;
  }
  for (const auto* key : {"surface", "incidence"})
    if (const auto field = find(root, key))
      reject(source, *field, fault::misplaced, "is for scenes of a [body]; there is none");
  const auto network = find(root, "network");
  if (network && find(root, "chain"))
    reject(source, *network, fault::contradiction, "a scene has a [chain] or a [network], not both");
  return false;
}

/// What is to be simulated needs a chain, and a law needs the masses of one or its own.
bool has_chain(const Source& source, const Field& root, const std::optional<Law>& law, Purpose purpose) {
  if (find(root, "chain")) return true;
  if (purpose == Purpose::simulation || !law || law->mass.empty())
    reject(source, root.place(), fault::no_model, "the scene has no [chain], [network] or [body]");
  return false;
}

/// Where the first of the tables that has its key says a number; else the first table.
Field where_said(const model::StatedNumber& number, const Field& root,
                 std::initializer_list<const char*> tables) {
  for (const auto* name : tables) {
    const auto table = find(root, name);
    const auto field = table && table->node->table() ? find(*table, number.key) : std::nullopt;
    if (!field) continue;
    const auto* list = field->node->array();
    return list && number.place >= 0 && number.place < std::ssize(*list) ? element(*field, number.place)
                                                                         : *field;
  }
  return *find(root, *tables.begin());
}

/// Whatever the reader let through, the model has the last word on what can be simulated. It is in the first
/// of the tables, and the others tell more of it.
template <class Model>
void expect_valid(const Source& source, const Field& root, std::initializer_list<const char*> tables,
                  const Model& model) {
  const auto table = *find(root, *tables.begin());
  try {
    model::validate(model);
    model::expect_representable(model);
  } catch (const model::Unrepresentable& error) {
    reject(source, where_said(error.reason, root, tables), error.fault, error.what());
  } catch (const InvalidParameter& error) {
    reject(source, table, error.fault, error.what());
  }
}

/// A wave through a chain makes an event per ball: the limit is for what does not end.
void allow_for_length(const std::optional<Field>& run, Scene& scene) {
  if (run && find(*run, "max_events")) return;
  scene.run.max_events = std::max<Index>(scene.run.max_events, 10 * std::ssize(scene.chain.mass));
}

void resolve_chain(Source& source, const Field& root, const std::optional<Field>& run, Scene& scene) {
  const auto chain = *find(root, "chain");
  auto resolved = read_chain(source, chain, run ? find(*run, "gravity") : std::nullopt);
  scene.chain = std::move(resolved.chain);
  scene.radius = std::move(resolved.radius);
  expect_valid(source, root, {"chain", "run"}, scene.chain);
  allow_for_length(run, scene);
}

void resolve_network(Source& source, const Field& root, const std::optional<Field>& run, Scene& scene) {
  const auto network = *find(root, "network");
  const auto gravity = run ? find(*run, "gravity") : std::nullopt;
  if (gravity) reject(source, *gravity, fault::misplaced, "does not act on networks");
  auto resolved = read_network(source, network);
  expect_valid(source, root, {"network"}, resolved.network);
  scene.network = std::move(resolved.network);
  scene.radius = std::move(resolved.radius);
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
  expect_keys(source, root, keys);
  const bool of_body = is_body_scene(source, root, purpose);
  Scene scene;
  if (const auto title = find(root, "title")) scene.title = read_title(source, *title);
  const auto run = find(root, "run");
  if (run) scene.run = read_run(source, *run, of_body);
  if (const auto sweeps = find(root, "sweep")) expect_sweeps(source, *sweeps);
  if (const auto columns = find(root, "columns")) expect_columns(source, *columns);
  if (const auto law = find(root, "law")) scene.law = read_law(source, *law);
  if (of_body) {
    scene.body = read_microbody(source, root, run);
    expect_valid(source, root, {"body", "surface", "incidence", "run"}, *scene.body);
  } else if (find(root, "network")) {
    resolve_network(source, root, run, scene);
  } else if (has_chain(source, root, scene.law, purpose)) {
    resolve_chain(source, root, run, scene);
  }
  return scene;
}

}  // namespace

Document parse_document(const std::string& text, const std::string& name, const Overrides& overrides) {
  Document document{.source = {.name = name, .origins = {}}, .tree = {}, .sha256 = {}};
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
