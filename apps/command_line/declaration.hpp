// A command line as data: what a program can be asked. The file parser.cpp alone knows how it is parsed.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <variant>
#include <vector>

namespace mariotte::command {

using Words = std::vector<std::string>;

/// What values an option takes; a function says what is wrong with one, or nothing.
struct Range {
  double least, most;  ///< both included
};
struct OneOf {
  Words words;
};
struct NotNegative {};
struct Positive {};
using Check = std::variant<std::monostate, Range, OneOf, NotNegative, Positive,
                           std::function<std::string(const std::string&)>>;

/// Where a value goes. A bool becomes true without a value; a list grows by every value.
using Target =
    std::variant<bool*, int*, std::int64_t*, std::uint64_t*, double*, std::string*, std::filesystem::path*,
                 Words*, std::vector<double>*, std::function<void(const std::string&)>>;

/// How an option is used, where it differs from the usual.
struct Usage {
  std::string value = {};  ///< what the help calls the value; empty: its type
  Check check = {};
  bool required = false;
  bool shows_default = false;       ///< in the help
  bool takes_one = false;           ///< of a list: one value each time it is given
  bool between_commas = false;      ///< of a list: "1,2,3" are three values
  Words needs = {}, excludes = {};  ///< names of options that must, or must not, be given as well
  Words choices = {};               ///< values that a shell offers; of a OneOf these are its words
};

struct Option {
  std::string name;  ///< "--out" or "-v,--verbose"; "SCENE" for a word without dashes
  Target target;
  std::string about;
  Usage usage = {};
};
using OptionList = std::vector<Option>;

/// One list of several.
OptionList joined(std::initializer_list<OptionList> lists);

struct Command {
  std::string name;
  std::string about;
  std::string footer = {};   ///< the end of its help; empty: that of the command above it
  std::string version = {};  ///< what --version prints; empty: there is no such option
  OptionList options = {};
  std::vector<Command> commands = {};  ///< one of them must be chosen, if there are any
  std::function<int()> act = {};       ///< what it does, if none of them; returns the exit code
  /// Stands for `act` where all words that follow are somebody else's, --help included.
  std::function<int(const Words&)> pass_on = {};
};

}  // namespace mariotte::command
