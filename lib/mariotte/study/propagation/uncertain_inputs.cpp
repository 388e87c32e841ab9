#include "mariotte/study/propagation/uncertain_inputs.hpp"

#include <cmath>
#include <optional>

#include "mariotte/core/quantity.hpp"
#include "mariotte/scene/field.hpp"
#include "mariotte/scene/key_path.hpp"

namespace mariotte::study {
namespace {

using scene::Document;
using scene::Node;

/// A value with a deviation, both as text, and what the scene had there.
struct Written {
  std::string key, deviation, whole;
  scene::Place place;
};

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(' ');
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// Empty for a bare number; none of what is no quantity.
std::optional<std::string> unit_of(const std::string& text) try {
  return parse_quantity(text).unit;
} catch (const QuantityError&) {
  return std::nullopt;
}

/// A unit behind the deviation alone is that of both: "40 ± 1 g".
std::string with_unit(const std::string& value, const std::string& deviation) {
  const auto unit = deviation.ends_with('%') ? std::nullopt : unit_of(deviation);
  return unit && !unit->empty() && unit_of(value) == "" ? value + " " + *unit : value;
}

/// "a ± b" with either sign, of a text that begins as a number does.
std::optional<std::pair<std::string, std::string>> split(const std::string& text) {
  if (trimmed(text).find_first_of("0123456789.+-") != 0) return std::nullopt;
  for (const auto sign : deviation_signs)
    if (const auto at = text.find(sign); at != text.npos) {
      const auto deviation = trimmed(text.substr(at + sign.size()));
      return {{with_unit(trimmed(text.substr(0, at)), deviation), deviation}};
    }
  return std::nullopt;
}

Node& node_of(Document& document, const Written& written) {
  return locate(document.source, document.tree, written.key, written.place);
}

void collect(Node& node, const std::string& key, std::vector<Written>& list) {
  if (auto* text = std::get_if<std::string>(&node.value)) {
    if (auto parts = split(*text)) {
      list.push_back({key, parts->second, *text, node.place});
      *text = parts->first;
    }
  } else if (auto* array = node.array()) {
    for (std::size_t i = 0; i < array->size(); ++i)
      collect((*array)[i], key + "[" + std::to_string(i) + "]", list);
  } else if (auto* table = node.table()) {
    for (auto& entry : *table) collect(entry.node, key.empty() ? entry.key : key + "." + entry.key, list);
  }
}

/// A bare number beside a unit would be one of SI, which nobody means.
void expect_unit(const Document& document, const Written& written, const Node& value) {
  const auto* text = std::get_if<std::string>(&value.value);
  const auto unit = text ? parse_quantity(*text).unit : "";
  if (unit.empty() || !parse_quantity(written.deviation).unit.empty()) return;
  reject(document.source, {&value, written.key}, fault::no_quantity,
         "the deviation '" + written.deviation + "' has no unit: write '" + written.deviation + " " + unit +
             "', or per cent");
}

/// Per cent of the value, or a quantity of its dimension.
double deviation_of(const Document& document, const Written& written, const Node& of,
                    const Dimension& dimension, double value) {
  const auto& text = written.deviation;
  const bool relative = text.ends_with('%');
  const Node node{relative ? trimmed(text.substr(0, text.size() - 1)) : text, written.place};
  const scene::Field field{&node, written.key};
  const double size =
      number(document.source, field, relative ? dimension::none : dimension, scene::Domain::finite);
  if (!(size > 0)) reject(document.source, field, fault::out_of_range, "its deviation must be positive");
  if (relative) return 0.01 * size * std::abs(value);
  expect_unit(document, written, of);
  return size;
}

UncertainInput input_of(const Document& document, const Written& written,
                        const scene::ReadingLog::Reading& reading) {
  const scene::Field field{reading.node, written.key};
  if (!reading.dimension)
    reject(document.source, field, fault::wrong_type, "has a deviation but is not read as a number");
  const double value = number(document.source, field, *reading.dimension, scene::Domain::finite);
  if (value == 0)
    reject(document.source, field, fault::wrong_type,
           "is zero: with a deviation, its outcomes have slopes on one side only");
  return {written.key, written.place, value,
          deviation_of(document, written, *reading.node, *reading.dimension, value)};
}

}  // namespace

std::vector<UncertainInput> take_uncertain_inputs(Document& document) {
  std::vector<Written> written;
  collect(document.tree, "", written);
  scene::ReadingLog watch;
  for (const auto& one : written) watch.readings.push_back({&node_of(document, one)});
  resolve(document, scene::Purpose::simulation, &watch);
  std::vector<UncertainInput> inputs;
  for (std::size_t i = 0; i < written.size(); ++i)
    if (watch.readings[i].is_text)
      node_of(document, written[i]).value = written[i].whole;
    else
      inputs.push_back(input_of(document, written[i], watch.readings[i]));
  return inputs;
}

}  // namespace mariotte::study
