// What the names of an expression stand for.
#pragma once
#include "mariotte/scene/document.hpp"
#include "mariotte/study/sweep/design.hpp"

namespace mariotte::study {

/// Whether a name is one of a scene's input: a key that begins with one of its tables, or what a design
/// varies.
bool is_input(const std::string& name, const Design& design);

/// What an input stands for: what is varied or derived, or a number that the scene gives. Throws
/// ExpressionError.
Term input_term(const std::string& name, const scene::Document& document, const Design& design);

/// An expression of inputs alone. Throws ExpressionError.
Formula read_formula(const std::string& text, const scene::Document& document, const Design& design);

}  // namespace mariotte::study
