#include "mariotte/study/sweep/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <numbers>
#include <string_view>

namespace mariotte::study {
namespace {

/// The parser would give a name another value: "x = 2" where "x == 2" is meant.
void expect_no_assignment(const std::string& text) {
  for (auto place = text.find('='); place != text.npos; place = text.find('=', place + 1)) {
    if (place + 1 < text.size() && text[place + 1] == '=')
      ++place;
    else if (place == 0 || std::string_view("<>!").find(text[place - 1]) == std::string_view::npos)
      throw ExpressionError("cannot read '" + text + "': '=' gives no value, '==' compares two");
  }
}

/// A key may count from the end, as "final.velocity[-1]", and the parser would subtract there.
constexpr std::string_view minus_of_index = "[-", as_name = "[~";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (auto at = text.find(from); at != text.npos; at = text.find(from, at))
    text.replace(at, from.size(), to);
  return text;
}

}  // namespace

bool is_name(const std::string& text) try {
  return Expression(text).names() == std::vector{text};
} catch (const ExpressionError&) {
  return false;
}

struct Expression::Parts {
  std::string text;
  mu::Parser parser;
  std::vector<std::string> names;
  std::vector<double> numbers;  ///< which the parser reads
};

Expression::Expression(const std::string& text) try : parts_(std::make_unique<Parts>()) {
  expect_no_assignment(text);
  parts_->text = text;
  auto& parser = parts_->parser;
  parser.DefineNameChars("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.[]~");
  parser.DefineConst("pi", std::numbers::pi);
  parser.SetExpr(replaced(text, minus_of_index, as_name));
  std::vector<std::string> used;
  for (const auto& [name, place] : parser.GetUsedVar()) used.push_back(name);
  parts_->numbers.resize(used.size(), 1);
  for (std::size_t i = 0; i < used.size(); ++i) {
    parser.DefineVar(used[i], &parts_->numbers[i]);
    parts_->names.push_back(replaced(used[i], as_name, minus_of_index));
  }
  int results = 0;
  parser.Eval(results);
  if (results != 1) throw ExpressionError("'" + text + "' has more than one value");
} catch (const mu::ParserError& error) {
  throw ExpressionError("cannot read '" + text + "': " + replaced(error.GetMsg(), as_name, minus_of_index));
}

Expression::Expression(const Expression& other) : Expression(other.text()) {}

Expression& Expression::operator=(const Expression& other) {
  parts_ = std::move(Expression(other).parts_);
  return *this;
}

Expression::~Expression() = default;

const std::string& Expression::text() const {
  return parts_->text;
}

const std::vector<std::string>& Expression::names() const {
  return parts_->names;
}

double Expression::operator()(std::span<const double> numbers) const {
  std::copy(numbers.begin(), numbers.end(), parts_->numbers.begin());
  return parts_->parser.Eval();
}

}  // namespace mariotte::study
