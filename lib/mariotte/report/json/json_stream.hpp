// JSON that is written while it is made, so that a large result needs no tree.
#pragma once
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace mariotte::report {

/// The object itself and lists of objects in it take a line per entry; everything below stays on its line.
/// Numbers have 17 significant digits and a point or an exponent, unless they are whole by their type; those
/// that are not finite become null, bytes that are not UTF-8 are replaced. A newline follows the end.
class JsonStream {
 public:
  using Value = nlohmann::ordered_json;

  /// `take` gets the text in pieces.
  explicit JsonStream(std::function<void(std::string_view)> take) : take_(std::move(take)) {}
  JsonStream(const JsonStream&) = delete;
  JsonStream& operator=(const JsonStream&) = delete;

  void open_object() { open(true); }
  void open_array() { open(false); }
  void close();  ///< whatever is open; after the outermost, all is taken
  void key(std::string_view name);
  /// The same, in its marks already: "\"name\": ".
  void ready_key(std::string_view text);
  void number(double value);
  void whole(std::int64_t value);
  void value(const Value& value);  ///< with all that is in it

 private:
  struct Level {
    bool object, lines, empty;
  };
  void open(bool object);
  void entry(bool object);  ///< what stands before an entry
  void scalar(const Value& value);

  std::function<void(std::string_view)> take_;
  std::string text_;
  std::vector<Level> levels_;
  bool after_key_ = false;
};

}  // namespace mariotte::report
