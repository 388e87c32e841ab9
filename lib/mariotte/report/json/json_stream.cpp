#include "mariotte/report/json/json_stream.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t piece = 1 << 16;

std::string in_marks(const JsonStream::Value& text) {
  return text.dump(-1, ' ', false, JsonStream::Value::error_handler_t::replace);
}

}  // namespace

void JsonStream::entry(bool object) {
  if (std::exchange(after_key_, false) || levels_.empty()) return;
  auto& [is_object, lines, empty] = levels_.back();
  if (empty && !is_object) lines = levels_.size() == 2 && object;
  if (!empty) text_ += lines ? "," : ", ";
  if (lines) text_.append("\n").append(2 * levels_.size(), ' ');
  empty = false;
  if (text_.size() < piece) return;
  take_(text_);
  text_.clear();
}

void JsonStream::open(bool object) {
  entry(object);
  text_ += object ? '{' : '[';
  levels_.push_back({.object = object, .lines = levels_.empty() && object, .empty = true});
}

void JsonStream::close() {
  const auto [object, lines, empty] = levels_.back();
  levels_.pop_back();
  if (lines && !empty) text_.append("\n").append(2 * levels_.size(), ' ');
  text_ += object ? '}' : ']';
  if (!levels_.empty()) return;
  take_(std::exchange(text_, {}) + "\n");
}

void JsonStream::key(std::string_view name) {
  ready_key(in_marks(name) + ": ");
}

void JsonStream::ready_key(std::string_view text) {
  entry(false);
  text_ += text;
  after_key_ = true;
}

void JsonStream::number(double value) {
  entry(false);
  if (!std::isfinite(value)) {
    text_ += "null";
    return;
  }
  const auto before = text_.size();
  if (value == 0 && std::signbit(value)) text_ += '-';  // programs get the same double
  append_exact(value, text_);
  if (text_.find_first_of(".e", before) == text_.npos) text_ += ".0";  // so that no reader takes it for whole
}

void JsonStream::whole(std::int64_t value) {
  entry(false);
  text_ += std::to_string(value);
}

void JsonStream::scalar(const Value& value) {
  text_ += in_marks(value);
}

void JsonStream::value(const Value& value) {
  if (value.is_number_float()) return number(value.get<double>());
  if (!value.is_structured()) {
    entry(false);
    return scalar(value);
  }
  open(value.is_object());
  for (const auto& [name, inner] : value.items()) {
    if (value.is_object()) key(name);
    this->value(inner);
  }
  close();
}

}  // namespace mariotte::report
