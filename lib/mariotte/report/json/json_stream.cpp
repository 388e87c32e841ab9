#include "mariotte/report/json/json_stream.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "mariotte/report/number.hpp"

namespace mariotte::report {
namespace {

constexpr std::size_t piece = 1 << 16;

bool is_plain(char c) {
  return c >= ' ' && c <= '~' && c != '"' && c != '\\';
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
  entry(false);
  if (std::all_of(name.begin(), name.end(), is_plain))  // nearly all are, and there are millions
    ((text_ += '"') += name) += '"';
  else
    scalar(name);
  text_ += ": ";
  after_key_ = true;
}

void JsonStream::number(double value) {
  entry(false);
  if (!std::isfinite(value)) {
    text_ += "null";
    return;
  }
  const auto before = text_.size();
  append_exact(value, text_);
  if (text_.find_first_of(".e", before) == text_.npos) text_ += ".0";  // so that no reader takes it for whole
}

void JsonStream::whole(std::int64_t value) {
  entry(false);
  text_ += std::to_string(value);
}

void JsonStream::scalar(const Value& value) {
  text_ += value.dump(-1, ' ', false, Value::error_handler_t::replace);
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
