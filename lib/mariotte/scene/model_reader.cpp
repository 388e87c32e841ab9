#include "mariotte/scene/model_reader.hpp"

#include <algorithm>
#include <string>

#include "mariotte/model/bodies/bodies_setting.hpp"
#include "mariotte/model/representable.hpp"
#include "mariotte/scene/bodies_reader.hpp"
#include "mariotte/scene/body_reader.hpp"
#include "mariotte/scene/chain_reader.hpp"
#include "mariotte/scene/drive_reader.hpp"
#include "mariotte/scene/idle_keys.hpp"
#include "mariotte/scene/network_reader.hpp"

namespace mariotte::scene {
namespace {

/// Where its drive, or the first of the tables that has its key, says a number; else that drive or the first
/// table.
Field where_said(const model::StatedNumber& number, const Field& root,
                 std::initializer_list<const char*> tables) {
  if (number.drive >= 0) {
    const auto table = drive_tables(*find(root, *tables.begin())).at(static_cast<std::size_t>(number.drive));
    return find(table, number.key).value_or(table);
  }
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

std::optional<Field> gravity(const Field& root) {
  const auto run = find(root, "run");
  return run ? find(*run, "gravity") : std::nullopt;
}

bool has_limit(const Field& root) {
  const auto run = find(root, "run");
  return run && (find(*run, "until") || find(*run, "max_time"));
}

/// What holds a row together holds it for ever.
void expect_limit(const Source& source, const Field& root, const Field& chain) {
  if (has_limit(root)) return;
  const auto force = find(chain, "precompression");
  reject(source, force ? *force : *find(chain, "start"), fault::missing,
         "a row in equilibrium does not come apart; it needs 'run.until' or 'run.max_time'");
}

/// So does what drives it.
void expect_limit_of_drive(const Source& source, const Field& root, const Field& whole) {
  const auto drive = find(whole, "drive");
  if (drive && !has_limit(root))
    reject(source, *drive, fault::missing,
           "what is driven never comes to an end; it needs 'run.until' or 'run.max_time'");
}

/// Or what stands on a wall.
void expect_limit_of_column(const Source& source, const Field& root, const Field& whole,
                            const model::Chain& chain) {
  if (!has_limit(root) && comes_to_rest(chain))
    reject(source, find(whole, "gravity").value_or(whole), fault::missing,
           "balls that stand on a wall come to rest there; they need 'run.until' or 'run.max_time'");
}

/// Of a chain or a network; `causes` are what could move it.
void warn_of_rest(Source& source, const Field& whole, const auto& model, const char* causes) {
  const auto is_zero = [](double value) { return value == 0; };
  const bool pressed = std::any_of(model.gap.begin(), model.gap.end(), [](double gap) { return gap < 0; });
  if (!pressed && model.drive.empty() && std::all_of(model.velocity.begin(), model.velocity.end(), is_zero))
    warn(source, whole, std::string("nothing moves: ") + causes);
}

ResolvedModel resolve_chain(Source& source, const Field& root, const Field& chain, Purpose purpose) {
  auto resolved = read_chain(source, chain, gravity(root));
  warn_of_idle_keys(source, chain);
  if (resolved.at_rest && purpose != Purpose::rest) expect_limit(source, root, chain);
  if (purpose != Purpose::rest) {
    expect_limit_of_drive(source, root, chain);
    expect_limit_of_column(source, root, chain, resolved.chain);
  }
  if (purpose != Purpose::rest && resolved.chain.gravity == 0)
    warn_of_rest(source, chain, resolved.chain, "no velocity, no gravity, no compressed contact");
  expect_valid(source, root, {"chain", "run"}, resolved.chain);
  return {std::move(resolved.chain), std::move(resolved.radius), std::move(resolved.touching)};
}

ResolvedModel resolve_network(Source& source, const Field& root, const Field& network, Purpose purpose) {
  if (const auto field = gravity(root)) reject(source, *field, fault::misplaced, "does not act on networks");
  auto resolved = read_network(source, network);
  warn_of_idle_keys(source, network);
  if (purpose != Purpose::rest) {
    expect_limit_of_drive(source, root, network);
    warn_of_rest(source, network, resolved.network, "no velocity, no compressed contact");
  }
  expect_valid(source, root, {"network"}, resolved.network);
  return {std::move(resolved.network), std::move(resolved.radius), std::move(resolved.touching),
          std::move(resolved.ball), resolved.reach};
}

/// Gravity brings bodies back to a plane for ever.
void expect_end(const Source& source, const Field& root, const Field& bodies, const model::Bodies& model) {
  if (norm(model.gravity) == 0 || model.plane.empty()) return;
  if (has_limit(root)) return;
  reject(source, *find(bodies, "gravity"), fault::missing,
         "bodies come back to their planes for ever; 'run.until' or 'run.max_time' is needed");
}

ResolvedModel resolve_bodies(Source& source, const Field& root, const Field& bodies) {
  if (const auto field = gravity(root))
    reject(source, *field, fault::misplaced, "of [bodies] is a vector, 'bodies.gravity'");
  auto resolved = read_bodies(source, bodies);
  warn_of_idle_keys(source, bodies);
  expect_end(source, root, bodies, resolved.bodies);
  try {
    model::validate(resolved.bodies);
    model::expect_digits(resolved.bodies);
    model::expect_end(resolved.bodies, has_limit(root) ? 0 : infinity);
  } catch (const InvalidParameter& error) {
    reject(source, bodies, error.fault, error.what());
  }
  return {std::move(resolved.bodies), {}, std::move(resolved.touching)};
}

ResolvedModel resolve_body(Source& source, const Field& root) {
  auto resolved = read_microbody(source, root, find(root, "run"));
  expect_valid(source, root, {"body", "surface", "incidence", "run"}, resolved.body);
  return {std::move(resolved.body), {}, std::move(resolved.touching)};
}

void expect_alone(const Source& source, const Field& root, const char* model, Purpose purpose) {
  for (const auto* key : {"chain", "network", "law", "body"})
    if (const auto field = find(root, key); field && key != std::string_view(model))
      reject(source, *field, fault::contradiction,
             "a scene has a [" + std::string(model) + "] or a [" + key + "], not both");
  if (purpose == Purpose::law && model == std::string_view("body"))
    reject(source, *find(root, model), fault::no_model, "impact laws need a [chain], [network] or [bodies]");
}

}  // namespace

void expect_one_model(const Source& source, const Field& root, Purpose purpose) {
  if (find(root, "bodies")) expect_alone(source, root, "bodies", purpose);
  if (find(root, "body")) return expect_alone(source, root, "body", purpose);
  for (const auto* key : {"surface", "incidence"})
    if (const auto field = find(root, key))
      reject(source, *field, fault::misplaced, "is for scenes of a [body]; there is none");
  const auto network = find(root, "network");
  if (network && find(root, "chain"))
    reject(source, *network, fault::contradiction, "a scene has a [chain] or a [network], not both");
}

ResolvedModel read_model(Source& source, const Field& root, const std::optional<Law>& law, Purpose purpose) {
  if (find(root, "body")) return resolve_body(source, root);
  if (const auto bodies = find(root, "bodies")) return resolve_bodies(source, root, *bodies);
  if (const auto network = find(root, "network")) return resolve_network(source, root, *network, purpose);
  if (const auto chain = find(root, "chain")) return resolve_chain(source, root, *chain, purpose);
  if (purpose != Purpose::law || !law || law->mass.empty())
    reject(source, root.place(), fault::no_model, no_model);
  return {LawAlone{}};
}

}  // namespace mariotte::scene
