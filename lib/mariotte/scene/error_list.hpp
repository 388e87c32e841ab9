// What is wrong with a scene, all of it: parts that do not need each other are read one after the other, and
// their errors are thrown together.
#pragma once
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "mariotte/scene/fault.hpp"
#include "mariotte/scene/scene.hpp"

namespace mariotte::scene {

class ErrorList {
 public:
  /// Reads a part; a SceneError waits for `raise`. Returns whether there was none.
  template <class Read>
  bool attempt(Read&& read) try {
    read();
    return true;
  } catch (const SceneError& error) {
    add(error);
    return false;
  }

  /// The same, of parts of which many may say what one has said: of several errors at a place the first is
  /// kept, and enough is enough.
  template <class Read>
  bool attempt_one_of_many(Read&& read) try {
    read();
    return true;
  } catch (const SceneError& error) {
    const auto here = [&](const SceneError& one) { return one.place == error.place && one.key == error.key; };
    if (errors_.size() < enough && std::none_of(errors_.begin(), errors_.end(), here)) add(error);
    return false;
  }

  /// The same, where a part that this one needs is wrong and was guessed: an error of a value by itself
  /// stays, but not one of how many there are.
  template <class Read>
  void attempt_on_a_guess(Read&& read) {
    ErrorList guessed;
    guessed.attempt(read);
    for (const auto& error : guessed.errors_)
      if (is_of_value(error)) add(error);
  }

  bool empty() const { return errors_.empty(); }

  /// Throws the first error in the order of the file, with the others as its `more`, if there are any. What
  /// is missing from a table with an unknown key may be misspelt there, and is not told.
  void raise() {
    if (errors_.empty()) return;
    std::erase_if(errors_, [&](const SceneError& error) { return is_missing(error) && is_misspelt(error); });
    std::stable_sort(errors_.begin(), errors_.end(),
                     [](const SceneError& a, const SceneError& b) { return rank(a) < rank(b); });
    SceneError first = errors_.front();
    first.more.assign(errors_.begin() + 1, errors_.end());
    throw first;
  }

 private:
  static constexpr std::size_t enough = 100;

  void add(const SceneError& error) {
    std::vector<SceneError> all{error};
    all.front().more.clear();
    all.insert(all.end(), error.more.begin(), error.more.end());
    for (auto& one : all) {
      const auto same = [&](const SceneError& known) { return std::string_view(known.what()) == one.what(); };
      if (std::none_of(errors_.begin(), errors_.end(), same)) errors_.push_back(std::move(one));
    }
  }
  /// Where it stands in the file; what is not the file's comes before it, and what concerns all of it after.
  static std::array<int, 3> rank(const SceneError& error) {
    return {error.key.empty(), error.line, error.column};
  }
  static bool is_of_value(const SceneError& error) {
    for (const auto& kind : {fault::no_quantity, fault::unknown_unit, fault::wrong_dimension,
                             fault::out_of_range, fault::unknown_word, fault::unknown_key, fault::wrong_type})
      if (error.fault.code == kind.code) return !error.key.ends_with(".number");
    return false;
  }
  static bool is_missing(const SceneError& error) {
    for (const auto& kind : {fault::missing, fault::no_mass, fault::no_stiffness})
      if (error.fault.code == kind.code) return true;
    return false;
  }
  bool is_misspelt(const SceneError& missing) const {
    const auto table = [](const SceneError& error) { return error.key.substr(0, error.key.find('.')); };
    return std::any_of(errors_.begin(), errors_.end(), [&](const SceneError& error) {
      return error.fault.code == fault::unknown_key.code && table(error) == table(missing);
    });
  }

  std::vector<SceneError> errors_;
};

}  // namespace mariotte::scene
