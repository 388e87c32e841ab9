// What only calls from Python can do wrong.
#pragma once
#include <string>

#include "mariotte/core/error.hpp"

namespace mariotte::python {

/// An option or a row of an array that makes no sense.
struct WrongOption : InvalidParameter {
  WrongOption(const Error& error, std::string name, std::string where = {})
      : InvalidParameter(error.what(), error.fault), key(std::move(name)), place(std::move(where)) {}

  std::string key;    ///< name of the option; empty of a row
  std::string place;  ///< as "row 3"; empty of an option
};

/// `act`, whose complaints are of the option `key`.
template <class Act>
void of_option(const char* key, Act act) try {
  act();
} catch (const Error& error) {
  throw WrongOption(error, key);
}

}  // namespace mariotte::python
