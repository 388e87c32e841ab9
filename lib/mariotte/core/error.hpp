// Broken promises. An expected end of a run is a value (hybrid::Ending), never an exception.
#pragma once
#include <stdexcept>
#include <string>

namespace mariotte {

/// Base of every exception this library throws; what() is a complete sentence for the user.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A parameter outside its domain (mass ≤ 0, exponent < 1, lengths that do not match …).
struct InvalidParameter : Error {
  using Error::Error;
};

}  // namespace mariotte
