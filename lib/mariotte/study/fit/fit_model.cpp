#include "mariotte/study/fit/fit_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "mariotte/hybrid/reached_limit.hpp"
#include "mariotte/impact/laws/restitution.hpp"
#include "mariotte/scene/field.hpp"
#include "mariotte/scene/key_path.hpp"
#include "mariotte/study/constant_restitution.hpp"
#include "mariotte/study/sweep/design_axes.hpp"

namespace mariotte::study {
namespace {

using scene::Node;
using scene::Place;

constexpr std::size_t most_letters = 12;  // of a number that a table can show as it was written

std::string place_of(const std::string& file, const Place& place) {
  return where({.name = file, .origins = {}}, place);
}

/// A number of many digits with six of them, and the unit behind it.
std::string shortened(const std::string& written) {
  double value = 0;
  const auto* end = written.data() + written.size();
  const auto [stop, problem] = std::from_chars(written.data(), end, value);
  if (written.size() <= most_letters || problem != std::errc()) return written;
  return fmt::format("{:.6g}{}", value, std::string_view(stop, end));
}

/// A key that the scene does not give: as a number it is unknown, or there is no value to start from.
[[noreturn]] void reject_missing(const scene::Document& document, const Place& place) {
  resolve(document);
  reject(document.source, place, fault::missing, "the scene gives no value to start from (--set one)");
}

}  // namespace

FitModel::FitModel(scene::Document document, const std::vector<std::string>& free, Measurements measurements)
    : document_(std::move(document)), measurements_(std::move(measurements)) {
  const auto scene = resolve(document_);
  accuracy_ = scene.run.accuracy;
  name_settings(scene);
  expect_quantity(scene);
  find_start(free);
  cell_ = add_origin(document_.source, measurements_.file);
  for (auto& row : measurements_.rows) resolve_row(row);
}

/// Words of the table that mean other keys in a chain.
void FitModel::name_settings(const scene::Scene& scene) {
  const bool is_chain = std::holds_alternative<model::Chain>(scene.model);
  for (std::size_t i = 0; i < measurements_.settings.size(); ++i) {
    auto& one = measurements_.settings[i];
    if (one.name == "speed" && is_chain) one.key = "chain.velocity[0]";
    if (one.name == "diameter") name_diameter(i, is_chain ? "chain" : "body");
    expect_new(i);
  }
}

/// Two words of the table may mean the same key.
void FitModel::expect_new(std::size_t i) const {
  const auto& all = measurements_.settings;
  for (std::size_t k = 0; k < i; ++k)
    if (all[k].key == all[i].key)
      throw scene::SceneError(
          place_of(measurements_.file, all[i].place) + ": '" + all[i].key + "' is set by another column, too",
          fault::wrong_columns);
}

/// Of measured diameters the halves are radii, unless the scene says 'diameter', too.
void FitModel::name_diameter(std::size_t i, const std::string& table) {
  const auto found = scene::find(scene::Field{&document_.tree, ""}, table);
  const bool is_whole = found && scene::find(*found, "diameter");
  measurements_.settings[i].key = table + (is_whole ? ".diameter" : ".radius");
  for (auto& row : measurements_.rows)
    if (is_whole) std::get<double>(row.values[i].value) *= 2;
}

void FitModel::expect_quantity(const scene::Scene& scene) {
  auto& quantity = measurements_.quantity;
  const auto* chain = std::get_if<model::Chain>(&scene.model);
  is_body_ = std::holds_alternative<model::Microbody>(scene.model);
  if (quantity == "restitution" && is_body_) quantity = "restitution.tip";
  std::vector<std::string> keys = {quantity};
  if (quantity == "restitution") {
    if (!chain || chain->mass.size() != 2)
      throw scene::SceneError(
          document_.source.name + ": only a body, or two balls of a [chain], have a restitution",
          fault::no_model);
    keys = {"final.velocity[0]", "final.velocity[1]"};
  }
  try {
    const auto columns = expand_columns(keys, scene);
    evaluate_ = make_evaluate(columns);
    if (quantity != "restitution")
      measurements_.unit = columns[0].unit, measurements_.symbol = columns[0].symbol;
  } catch (const ColumnError& problem) {
    throw scene::SceneError(
        place_of(measurements_.file, measurements_.quantity_place) + ": " + problem.what(), problem.fault);
  }
  columns_.resize(keys.size());
  outcomes_ = outcomes_of(keys, scene);
}

void FitModel::find_start(const std::vector<std::string>& free) {
  for (const auto& key : free) {
    const auto place = add_origin(document_.source, "--free " + key);
    for (const auto& setting : measurements_.settings)
      if (setting.key == key)
        reject(document_.source, place, fault::contradiction, "the measurements set it");
    if (std::find(free_.begin(), free_.end(), key) != free_.end())
      reject(document_.source, place, fault::contradiction, "is named twice");
    free_.push_back(key);
    free_places_.push_back(place);
    expect_start(free_.size() - 1);
  }
}

void FitModel::expect_start(std::size_t index) {
  const auto& place = free_places_[index];
  Node& node = locate(document_.source, document_.tree, free_[index], place);
  if (node.place.origin == place.origin) {
    node.value = 1.0;
    reject_missing(document_, place);
  }
  scene::ReadingLog watch{.readings = {{.node = &node}}};
  resolve(document_, scene::Purpose::simulation, &watch);
  if (!watch.readings[0].dimension)
    reject(document_.source, place, fault::wrong_type, "is no number of the scene");
  node.place = place;
  start_.push_back(
      number(document_.source, {&node, free_[index]}, *watch.readings[0].dimension, scene::Domain::positive));
  node.value = start_.back();
}

void FitModel::set(const std::vector<Node>& settings) {
  for (std::size_t i = 0; i < settings.size(); ++i) {
    Node& node = locate(document_.source, document_.tree, measurements_.settings[i].key, cell_);
    node = settings[i];
    node.place = cell_;
  }
}

/// Of a pair whose restitution was measured.
void FitModel::expect_approach(const scene::Scene& scene) const {
  if (measurements_.quantity != "restitution") return;
  const auto& velocity = std::get<model::Chain>(scene.model).velocity;
  if (!(velocity[0] > velocity[1]))
    throw scene::SceneError("the balls do not approach each other, so they have no restitution",
                            fault::no_approach);
}

/// Texts that the scene reads as numbers become numbers.
void FitModel::resolve_row(Measurement& row) {
  document_.source.origins.back() = place_of(measurements_.file, row.place);
  set(row.values);
  scene::ReadingLog watch;
  for (const auto& one : measurements_.settings)
    watch.readings.push_back({.node = &locate(document_.source, document_.tree, one.key, cell_)});
  try {
    expect_approach(resolve(document_, scene::Purpose::simulation, &watch));
  } catch (const scene::SceneError& error) {
    const auto& row_place = document_.source.origins.back();
    if (std::string_view(error.what()).starts_with(row_place)) throw;
    throw scene::SceneError(row_place + ": " + error.what(), error.fault);
  }
  for (std::size_t i = 0; i < row.values.size(); ++i) {
    const auto& reading = watch.readings[i];
    if (!reading.dimension) continue;
    const double value = number(document_.source, {reading.node, ""}, *reading.dimension, scene::Domain::any);
    row.values[i].value = value;
    measurements_.settings[i].unit = unit_of_key(measurements_.settings[i].key, *reading.dimension);
    row.written[i] = shortened(row.written[i]);
  }
}

std::vector<std::string> FitModel::warnings_of_speeds() try {
  const auto& settings = measurements_.settings;
  const auto one = std::ranges::find_if(settings, [](const Setting& each) { return is_speed(each.key); });
  if (one == settings.end()) return {};
  const auto place = static_cast<std::size_t>(one - settings.begin());
  const auto speed_of = [&](const Measurement& row) {
    const auto* number = std::get_if<double>(&row.values[place].value);
    return number ? *number : 0;
  };
  const auto [slow, fast] = std::ranges::minmax_element(measurements_.rows, {}, speed_of);
  auto values = slow->values;
  const auto slowest = scene_at(values, start_);
  values[place] = fast->values[place];
  return warn_of_constant_restitution(document_, slowest, scene_at(values, start_));
} catch (const Error&) {  // no row has both
  return {};
}

Prediction FitModel::of_row(std::size_t row, std::span<const double> values) try {
  return at(measurements_.rows[row].values, values);
} catch (const Error& error) {
  throw Error(place_of(measurements_.file, measurements_.rows[row].place) + ": " + error.what(), error.fault);
}

void FitModel::set_free(std::size_t i, double value) {
  locate(document_.source, document_.tree, free_[i], free_places_[i]).value = value;
}

scene::Scene FitModel::scene_at(const std::vector<Node>& settings, std::span<const double> values) {
  set(settings);
  for (std::size_t i = 0; i < free_.size(); ++i) set_free(i, values[i]);
  return resolve(document_);
}

Prediction FitModel::at(const std::vector<Node>& settings, std::span<const double> values) {
  const auto scene = scene_at(settings, values);
  const auto* body = std::get_if<model::Microbody>(&scene.model);
  const auto prediction = body && measurements_.quantity.starts_with("restitution")
                              ? of_body(*body, scene.run)
                              : of_result(scene);
  watch_();
  ++runs_;
  return prediction;
}

Prediction FitModel::of_body(const model::Microbody& body, const hybrid::Options& options) {
  const auto& end = solver_.solve(first_impact(body), options);
  if (end.ending == hybrid::Ending::captured) return {.value = 0, .captured = true};
  if (end.ending != hybrid::Ending::separated)
    throw Error(std::string("the run ended with ") + hybrid::name(end.ending) + ": " +
                (end.message.empty() ? reached_limit(end.ending, options) : end.message));
  const auto e =
      impact::restitution(tip_velocity(body, 0), end.tip_velocity, body.velocity.e1, end.velocity.e1);
  return {.value = measurements_.quantity == "restitution.centre" ? e.centre : e.tip, .captured = false};
}

Prediction FitModel::of_result(const scene::Scene& scene) {
  const auto verdict = evaluate_(scene, columns_);
  const bool is_restitution = columns_.size() > 1;
  if (is_restitution && verdict.ending == hybrid::name(hybrid::Ending::bound))
    return {.value = 0, .captured = true};
  if (!verdict.has_numbers()) throw Error("the run ended with " + verdict.ending + ": " + verdict.reason);
  if (columns_.size() == 1) return {.value = columns_[0], .captured = false};
  const auto& before = std::get<model::Chain>(scene.model).velocity;
  return {.value = (columns_[1] - columns_[0]) / (before[0] - before[1]), .captured = false};
}

}  // namespace mariotte::study
