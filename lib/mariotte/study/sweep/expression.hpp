// Arithmetic over named numbers, "kappa * chain.contact[0].stiffness". Names are words, or keys of a scene or
// a result. muParser reads it: + - * / ^, parentheses, comparisons, a ? b : c, sqrt, exp, ln, log10, sin,
// cos, abs, min, max, pi and more.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "mariotte/core/error.hpp"
#include "mariotte/study/fault.hpp"

namespace mariotte::study {

/// A text that is no expression; what() says why.
struct ExpressionError : Error {
  explicit ExpressionError(const std::string& what) : Error(what, fault::sweep_values) {}
};

/// A copy is independent; one object is not to be shared between threads.
class Expression {
 public:
  /// Throws ExpressionError.
  explicit Expression(const std::string& text);
  Expression(const Expression& other);
  Expression& operator=(const Expression& other);
  ~Expression();

  const std::string& text() const;
  /// In the order in which the numbers are wanted.
  const std::vector<std::string>& names() const;
  /// Its value where the names have these numbers; nan or infinite where it is not defined.
  double operator()(std::span<const double> numbers) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// An expression that is this word alone reads it as a name: not as a constant or a function.
bool is_name(const std::string& text);

}  // namespace mariotte::study
