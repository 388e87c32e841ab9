#include "mariotte/study/sweep/expression.hpp"

#include <muParser.h>

#include <algorithm>
#include <numbers>

namespace mariotte::study {

struct Expression::Parts {
  std::string text;
  mu::Parser parser;
  std::vector<std::string> names;
  std::vector<double> numbers;  ///< which the parser reads
};

Expression::Expression(const std::string& text) try : parts_(std::make_unique<Parts>()) {
  parts_->text = text;
  auto& parser = parts_->parser;
  parser.DefineNameChars("0123456789_abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.[]");
  parser.DefineConst("pi", std::numbers::pi);
  parser.SetExpr(text);
  for (const auto& [name, place] : parser.GetUsedVar()) parts_->names.push_back(name);
  parts_->numbers.resize(parts_->names.size(), 1);
  for (std::size_t i = 0; i < parts_->names.size(); ++i)
    parser.DefineVar(parts_->names[i], &parts_->numbers[i]);
  int results = 0;
  parser.Eval(results);
  if (results != 1) throw ExpressionError("'" + text + "' has more than one value");
} catch (const mu::ParserError& error) {
  throw ExpressionError("cannot read '" + text + "': " + error.GetMsg());
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
