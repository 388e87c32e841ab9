// What is wrong with a scene, all of it: parts that do not need each other are read one after the other, and
// their errors are thrown together.
#pragma once
#include <utility>
#include <vector>

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
    errors_.push_back(error);
    return false;
  }

  /// Throws the first error, with the others as its `more`, if there are any.
  void raise() {
    if (errors_.empty()) return;
    std::vector<SceneError> all;
    for (const auto& error : errors_) {
      all.push_back(error);
      all.back().more.clear();
      all.insert(all.end(), error.more.begin(), error.more.end());
    }
    SceneError first = std::move(all.front());
    first.more.assign(all.begin() + 1, all.end());
    throw first;
  }

 private:
  std::vector<SceneError> errors_;
};

}  // namespace mariotte::scene
