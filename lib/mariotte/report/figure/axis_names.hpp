// What stands beside the axes of figures, in gnuplot's enhanced text.
#pragma once
#include <string>
#include <string_view>

namespace mariotte::report {

/// Text whose marks have no meaning: "a_b" with its underscore.
std::string plain(const std::string& text);

/// The same of a name that a user has given; "kappa" is κ, "alpha_1" is α with an index.
std::string greek(const std::string& name);

/// Words and symbol of a number of a result by its key and the symbol that it has there; balls and contacts
/// count from 1: "final velocity v_{3}" for "final.velocity[2]" and "v_i".
std::string name_of_result(const std::string& key, std::string_view symbol);

/// The symbol alone, or words where there is none: "v_{3}", "stored 2".
std::string short_name_of_result(const std::string& key, std::string_view symbol);

/// The same of what a scene says: "gap g_{2}" for "chain.gap[1]".
std::string name_of_input(const std::string& key);

/// "∂v_{3}/∂m_{1}" of "sensitivity.velocity[2].mass[0]".
std::string name_of_slope(const std::string& key);

/// A name with its unit in brackets: "gap g_{2} [µm]"; alone if it has none.
std::string with_unit(const std::string& name, const std::string& unit);

}  // namespace mariotte::report
