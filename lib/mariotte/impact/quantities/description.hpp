// What a quantity is, without a result.
#pragma once
#include <array>
#include <string_view>

namespace mariotte::impact {

/// What is said of a quantity wherever it stands.
struct Description {
  std::string_view key;      ///< its path in JSON, [] for any index: "contacts[].impulse"
  std::string_view unit;     ///< SI; "1" for a pure number, empty for what is no number
  std::string_view symbol;   ///< as on the theory page; may be empty
  std::string_view meaning;  ///< one line
};

/// The samples of a chain or network: the tables of a trace in HDF5 by key, the columns of trace.csv by
/// symbol. Velocities of degrees of freedom that are not balls have units of their own.
inline constexpr std::array<Description, 4> sampled = {
    {{"time", "s", "time", "when the sample was taken"},
     {"velocity", "m/s", "v", "velocity of the ball"},
     {"gap", "m", "gap", "gap of the contact, negative in contact"},
     {"force", "N", "force", "force of the contact"}}};

}  // namespace mariotte::impact
