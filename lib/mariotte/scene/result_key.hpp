// Where the ball or the contact of a key stands in results.
#pragma once
#include <string>

#include "mariotte/scene/document.hpp"

namespace mariotte::scene {

/// The same key with that place in its brackets: a table may have a `number`, and a wall on the left is the
/// first ball. "chain.ball[4].velocity" for "chain.ball[0].velocity" if that is ball 5. Any other key stays.
std::string key_in_results(const Document& document, const std::string& key);

}  // namespace mariotte::scene
