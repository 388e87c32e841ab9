#include "mariotte/study/sweep/columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>

#include "mariotte/core/nearest.hpp"
#include "mariotte/core/overload.hpp"
#include "mariotte/impact/quantities/quantity_key.hpp"
#include "mariotte/study/sweep/slope_columns.hpp"

namespace mariotte::study {
namespace {

using impact::Entry;
using impact::Quantity;

constexpr Index most_elements = 16;  // of a longer array the ends stand for all, unless asked

bool is_index(std::string_view text) {
  return text == "*" || text.find_first_not_of("0123456789", text.starts_with('-')) == text.npos;
}

/// What stands between the brackets of a key, one after the other; empty where it is no index.
std::vector<std::string> indices_in(std::string_view key) {
  std::vector<std::string> all;
  for (auto open = key.find('['); open != key.npos; open = key.find('[', open + 1)) {
    const auto text = key.substr(open + 1, key.find_first_of("].", open) - open - 1);
    all.emplace_back(is_index(text) ? text : "");
  }
  return all;
}

/// A pattern with these indices, 0 where there is none.
std::string with_indices(std::string_view pattern, const std::vector<std::string>& indices) {
  std::string key;
  std::size_t used = 0;
  for (const char c : pattern) {
    key += c;
    if (c == '[') key += used < indices.size() && !indices[used].empty() ? indices[used] : "0", ++used;
  }
  return key;
}

/// The keys that lead to numbers, with these indices.
template <class Impact>
std::vector<std::string> known_keys(const std::vector<std::string>& indices) {
  std::vector<std::string> known;
  for (const auto& one : impact::quantities<Impact>()) {
    if (!one.is.unit.empty()) known.push_back(with_indices(one.is.key, indices));
    if (one.count)
      known.push_back(with_indices(one.is.key.substr(0, one.is.key.size() - 2), indices) + ".count");
  }
  return known;
}

/// The name whose part after the first dot is nearest to a key; without an index if the key has none.
std::string suggestion_by_end(std::string_view key, std::span<const std::string_view> names) {
  std::vector<std::string_view> ends;
  const bool has_index = key.find('[') != key.npos;
  for (const auto name : names) {
    const auto end = name.substr(name.find('.') + 1);
    ends.push_back(has_index ? end : end.substr(0, end.find('[')));
  }
  const auto end = nearest(key, ends);
  if (end.empty()) return "";
  const auto which = std::find(ends.begin(), ends.end(), end) - ends.begin();
  return fmt::format(" (did you mean '{}'?)", names[static_cast<std::size_t>(which)]);
}

/// The nearest key that leads to a number; one that ends like `key` is nearer than any misspelling.
template <class Impact>
std::string suggested_key(const std::string& key) {
  const auto known = known_keys<Impact>(indices_in(key));
  const std::vector<std::string_view> names(known.begin(), known.end());
  const auto whole = suggested_path(key, names);
  return whole.empty() ? suggestion_by_end(key, names) : whole;
}

/// Of a key that is a number of some result of this kind. Throws ColumnError.
template <class Impact>
Entry<Impact> entry_of(const std::string& key) {
  const auto parsed = impact::parse_key(key);
  if (!parsed)
    throw ColumnError(fmt::format("'{}' needs an index in brackets, from 0, or * for all{}", key,
                                  suggested_key<Impact>(key)));
  if (const auto entry = impact::find_entry<Impact>(*parsed)) {
    if (!entry->counts && entry->quantity->is.unit.empty())
      throw ColumnError(fmt::format("'{}' is no number", key));
    return *entry;
  }
  if (impact::find_quantity<Impact>(parsed->pattern + "[]"))
    throw ColumnError(fmt::format("'{}' needs an index in brackets, from 0, or * for all", key));
  if (key == "ending" || key == "reason")
    throw ColumnError(fmt::format("'{}' is a column of every sweep, and needs no key", key));
  throw ColumnError(fmt::format("no result has '{}'{}", key, suggested_key<Impact>(key)));
}

/// Writes keys out for one model.
template <class Model>
class Expansion {
  using Impact = decltype(impact::unfilled(std::declval<const Model&>()));

 public:
  Expansion(const Model& model, const scene::Scene& scene, Counting counting, const scene::Document* document)
      : model_(model),
        scene_(scene),
        document_(document),
        run_(scene.run),
        result_(impact::unfilled(model)),
        counting_(counting),
        may_run_(counting == Counting::by_run) {}

  std::vector<Column> operator()(const std::vector<std::string>& keys) {
    for (const auto& key : keys.empty() ? default_keys() : keys)
      is_slope(key) ? add_slope(key) : expand_all(key);
    return std::move(columns_);
  }

 private:
  /// Throws BeyondEnd if * stands for nothing, unless a run has to tell.
  void expand_all(const std::string& key) {
    const auto before = added_;
    expand(key, entry_of<Impact>(key));
    if (added_ == before && counting_ == Counting::by_run)
      throw BeyondEnd(fmt::format("'{}' stands for nothing: that array is empty{}", key, unnumbered()));
  }
  void expand(const std::string& key, const Entry<Impact>& entry, std::size_t level = 0) {
    if (!entry.has_index(level)) return add(key, *entry.quantity);
    if (entry.at[level] != impact::every_index) {
      expect(key, entry, level);
      return expand(key, entry, level + 1);
    }
    auto each = entry;
    const Index count = length(entry, level);
    for (each.at[level] = 0; each.at[level] < count; ++each.at[level])
      expand(std::string(key).replace(key.find("[*]"), 3, fmt::format("[{}]", each.at[level])), each,
             level + 1);
  }

  void add(const std::string& key, const Quantity<Impact>& quantity) {
    const auto& [pattern, unit, symbol, meaning] = quantity.is;
    ++added_;
    if (!known_.insert(key).second) return;
    columns_.push_back({key, std::string(key.ends_with(".count") ? "1" : unit), symbol, meaning});
  }

  void add_slope(const std::string& key) {
    if (!document_) throw ColumnError("'" + key + "': slopes are columns of sweeps alone");
    const WrittenScene example{*document_, scene_};
    const bool may_run = counting_ == Counting::by_run;
    for (const auto& one : each_slope(key, example, may_run)) {
      expect_slope(one, example, may_run);
      if (known_.insert(one).second)
        columns_.push_back({one, unit_of_slope(one, example), "", "slope of an outcome by a number"});
    }
  }

  /// Throws BeyondEnd if the model is too small for the index.
  void expect(const std::string& key, Entry<Impact> entry, std::size_t level) const {
    const auto& array = *entry.arrays[level];
    if (array.counted_by_run || impact::find_place(entry, result_, level + 1)) return;
    const Index count = array.count(result_, entry.at).value_or(0);
    const auto name = array.is.key.substr(0, array.is.key.size() - 2);
    throw BeyondEnd(fmt::format("'{}' does not exist: {}{}", key,
                                count == 0 ? fmt::format("this scene has no {}", name)
                                           : fmt::format("the last is {}[{}]", name, count - 1),
                                name == "contacts" ? unnumbered() : ""));
  }
  /// Why pairs of bodies that may touch are not among the contacts.
  std::string unnumbered() const {
    if constexpr (std::is_same_v<Model, model::Bodies>)
      if (always_told(model_) < std::ssize(model_.contact))
        return "; of so many pairs only those that [[bodies.contact]] names have numbers that stay";
    return "";
  }

  /// Runs the scene if nothing less tells; 0 where an array around it has no such index.
  Index length(Entry<Impact> entry, std::size_t level) {
    const auto last = entry.arrays.begin() + static_cast<std::ptrdiff_t>(level) + 1;
    if (may_run_ && std::any_of(entry.arrays.begin(), last, [](auto* one) { return one->counted_by_run; })) {
      result_ = impact::simulate(model_, run_);
      may_run_ = false;
    }
    if (!impact::find_place(entry, result_, level)) return 0;
    return entry.arrays[level]->count(result_, entry.at).value_or(0);
  }

  /// The numbers that say most, of whatever kind the result is.
  std::vector<std::string> default_keys() const {
    std::vector<std::string> keys;
    for (const auto* name : {"final.velocity", "final.spin", "icr"}) {
      const auto* array = impact::find_quantity<Impact>(std::string(name) + "[]");
      const Index size = array ? array->count(result_, {}).value_or(0) : 0;
      if (size > most_elements)
        keys.insert(keys.end(), {fmt::format("{}[0]", name), fmt::format("{}[{}]", name, size - 1)});
      else if (size > 0)
        keys.push_back(fmt::format("{}[*]", name));
    }
    if constexpr (std::is_same_v<Model, model::Bodies>)
      for (const auto* key : {"final.bodies[*].velocity[*]",
                              model_.dimension == 2 ? "final.bodies[*].spin" : "final.bodies[*].spin[*]"})
        keys.emplace_back(key);
    for (const auto* name : {"restitution.tip", "restitution.centre", "energy.final"})
      if (impact::find_quantity<Impact>(name)) keys.emplace_back(name);
    return keys;
  }

  const Model& model_;
  const scene::Scene& scene_;
  const scene::Document* document_;
  const hybrid::Options& run_;
  Impact result_;  ///< its lengths alone, until the scene has been run
  Counting counting_;
  bool may_run_;  ///< and has not been yet
  std::vector<Column> columns_;
  std::set<std::string> known_;
  std::size_t added_ = 0;  ///< columns, also those that were known
};

}  // namespace

std::vector<Column> expand_columns(const std::vector<std::string>& keys, const scene::Scene& scene,
                                   Counting counting, const scene::Document* document) {
  using Columns = std::vector<Column>;
  return std::visit(
      Overload{[&](const auto& model) { return Expansion(model, scene, counting, document)(keys); },
               [](const scene::LawAlone& nothing) -> Columns { scene::refuse(nothing); }},
      scene.model);
}

}  // namespace mariotte::study
