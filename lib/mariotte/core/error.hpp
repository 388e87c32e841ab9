// Broken promises. An expected end of a run is a value (hybrid::Ending), never an exception.
#pragma once
#include <stdexcept>
#include <string>

#include "mariotte/core/fault.hpp"

namespace mariotte {

/// Base of every exception this library throws; what() is a complete sentence for the user.
struct Error : std::runtime_error {
  explicit Error(const std::string& what, Fault kind = fault::stopped)
      : std::runtime_error(what), fault(kind) {}

  Fault fault;
};

/// A parameter outside its domain (mass ≤ 0, exponent < 1, lengths that do not match …).
struct InvalidParameter : Error {
  explicit InvalidParameter(const std::string& what, Fault kind = fault::impossible) : Error(what, kind) {}
};

}  // namespace mariotte
