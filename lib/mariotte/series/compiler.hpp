// From a field to its program, while the program that uses it is compiled.
#pragma once
#include <algorithm>

#include "mariotte/series/field.hpp"
#include "mariotte/series/program.hpp"
#include "mariotte/series/symbol.hpp"

namespace mariotte::series {

/// Makes the program of a recording.
class Compiler {
 public:
  constexpr explicit Compiler(const Recording& recording) : recording_(recording) {
    for (int i = 0; i < Recording::limit; ++i) step_of_[i] = fixed_of_[i] = -1;
  }

  /// `node` holds the rates of the states, then the other rows.
  constexpr Program run(const int* node, int states, int rows) {
    for (int i = 0; i < states; ++i) add_state(i);
    for (int i = 0; i < rows; ++i) count_uses(node[i]);
    for (int i = states; i < rows; ++i) program_.value[i] = value(node[i], i);
    for (int i = 0; i < program_.steps; ++i) program_.step[i].seen = i >= states;
    for (int i = 0; i < states; ++i) program_.rate[i] = rate(node[i]);
    place_rows(rows);
    return program_;
  }

 private:
  constexpr void add_state(int i) {
    step_of_[recording_.make_state(i)] = push({.op = Op::state, .a = i, .keeps = true, .row = i});
  }

  constexpr int push(const Step& step) {
    program_.step[program_.steps] = step;
    return program_.steps++;
  }

  constexpr void count_uses(int i) {
    if (recording_.is_constant(i) || uses_[i]++ > 0) return;
    const Node& node = recording_[i];
    if (node.op == Op::state) return;
    if (!recording_.is_constant(node.a)) count_uses(node.a);
    if (has_second(node.op)) count_uses(node.b);
  }

  static constexpr bool has_second(Op op) { return op == Op::sum || op == Op::product || op == Op::quotient; }
  constexpr bool is_linear(int i) const { return recording_[i].op == Op::sum || recording_.is_scaled(i); }

  constexpr int fixed(int i) {
    if (fixed_of_[i] >= 0) return fixed_of_[i];
    Node node = recording_[i];
    if (node.op != Op::parameter && node.op != Op::number) {
      node.a = fixed(node.a);
      if (node.b >= 0) node.b = fixed(node.b);
    }
    program_.fixed[program_.fixed_values] = node;
    return fixed_of_[i] = program_.fixed_values++;
  }

  constexpr Term term(int step, int factor) {
    if (recording_.is_number(factor)) return {step, recording_[factor].number, -1};
    return {step, 1, fixed(factor)};
  }

  constexpr Term rate(int i) {
    if (recording_.is_constant(i)) return term(-1, i);
    if (recording_.is_scaled(i)) return term(lower(recording_[i].b), recording_[i].a);
    return term(lower(i), recording_.make_number(1));
  }

  /// The step that keeps the row; what has a row already is copied by a sum of one term.
  constexpr Term value(int i, int row) {
    if (recording_.is_constant(i)) return term(-1, i);
    int step = lower(i);
    if (program_.step[step].row >= 0) {
      program_.term[program_.terms] = {step, 1, -1};
      step = push({.op = Op::sum, .first = program_.terms++, .count = 1, .depth = program_.step[step].depth});
    }
    program_.step[step].row = row;
    return {step, 1, -1};
  }

  /// Terms of a sum; sums within it are opened unless somebody else needs them as well.
  struct Terms {
    Term term[Program::limit / 2] = {};
    int factor[Program::limit / 2] = {};
    int count = 0, constant = -1;
  };
  constexpr void flatten(int i, int factor, bool open, Terms& to) {
    if (recording_.is_constant(i)) {
      const int part = recording_.make_product(factor, i);
      to.constant = to.constant < 0 ? part : recording_.make_sum(to.constant, part);
    } else if (recording_.is_scaled(i)) {
      flatten(recording_[i].b, recording_.make_product(factor, recording_[i].a),
              open && uses_[recording_[i].b] == 1, to);
    } else if (open && recording_[i].op == Op::sum) {
      flatten(recording_[i].a, factor, uses_[recording_[i].a] == 1, to);
      flatten(recording_[i].b, factor, uses_[recording_[i].b] == 1, to);
    } else {
      add_term(lower(i), factor, to);
    }
  }
  constexpr void add_term(int step, int factor, Terms& to) {
    for (int k = 0; k < to.count; ++k)
      if (to.term[k].step == step) {
        to.factor[k] = recording_.make_sum(to.factor[k], factor);
        return;
      }
    to.term[to.count].step = step;
    to.factor[to.count++] = factor;
  }

  constexpr int lower_sum(int i) {
    Terms terms;
    flatten(i, recording_.make_number(1), true, terms);
    for (int k = 0; k < terms.count; ++k) terms.term[k] = term(terms.term[k].step, terms.factor[k]);
    sort_by_depth(terms);
    Step step{.op = Op::sum, .first = program_.terms, .count = terms.count};
    if (terms.constant >= 0) step.fixed = fixed(terms.constant);
    for (int k = 0; k < terms.count; ++k) program_.term[program_.terms++] = terms.term[k];
    step.depth = program_.step[terms.term[terms.count - 1].step].depth + 4;
    return push(step);
  }
  /// What is known last comes last.
  constexpr void sort_by_depth(Terms& terms) const {
    const auto depth = [&](int k) { return program_.step[terms.term[k].step].depth; };
    for (int k = 1; k < terms.count; ++k)
      for (int j = k; j > 0 && depth(j) < depth(j - 1); --j) std::swap(terms.term[j], terms.term[j - 1]);
  }

  constexpr int lower(int i) {
    if (step_of_[i] >= 0) return step_of_[i];
    const Op op = recording_[i].op;
    if (op == Op::sine || op == Op::cosine) return lower_turn(i);
    return step_of_[i] = is_linear(i) ? lower_sum(i) : lower_operation(i);
  }

  constexpr int lower_operation(int i) {
    const Node& node = recording_[i];
    Step step{.op = node.op};
    if (recording_.is_constant(node.a))
      step.fixed = fixed(node.a);
    else
      step.a = lower(node.a);
    if (has_second(node.op)) step.b = lower(node.b);
    if (node.op == Op::map) step.b = node.b;
    if (node.op == Op::power) step.fixed = fixed(node.b);
    if (step.a >= 0) step.depth = program_.step[step.a].depth;
    if (has_second(node.op)) step.depth = std::max(step.depth, program_.step[step.b].depth);
    step.depth += node.op == Op::power ? 12 : 4;
    const bool convolves = node.op != Op::map;
    step.keeps = convolves && node.op != Op::product;
    step.keeps_slopes = false;
    if (node.op == Op::product || node.op == Op::power) program_.step[step.a].keeps = true;
    if (node.op == Op::product || node.op == Op::quotient) program_.step[step.b].keeps = true;
    if (node.op == Op::power || node.op == Op::exponential) program_.step[step.a].keeps_slopes = true;
    return push(step);
  }

  constexpr int lower_turn(int i) {
    const int sine = recording_[i].op == Op::sine ? i : i - 1, a = lower(recording_[i].a);
    program_.step[a].keeps_slopes = true;
    const int at = program_.steps, depth = program_.step[a].depth + 8;
    step_of_[sine] = push({.op = Op::sine, .a = a, .b = at + 1, .depth = depth, .keeps = true});
    step_of_[sine + 1] = push({.op = Op::cosine, .a = a, .b = at, .depth = depth, .keeps = true});
    return step_of_[i];
  }

  constexpr void place_rows(int rows) {
    program_.rows = rows;
    for (int i = 0; i < program_.steps; ++i) {
      Step& step = program_.step[i];
      if (step.keeps && step.row < 0) step.row = program_.rows++;
      if (step.keeps_slopes) step.slopes = program_.rows++;
    }
    for (int i = 0; i < program_.steps; ++i)
      if (program_.step[i].seen) place_convolutions(i);
    program_.seen_convolutions = program_.convolutions;
    for (int i = 0; i < program_.steps; ++i)
      if (!program_.step[i].seen) place_convolutions(i);
  }
  constexpr int convolve(Factor a, Factor b) {
    program_.convolution[program_.convolutions] = {a, b};
    return program_.convolutions++;
  }
  constexpr void place_convolutions(int i) {
    Step& step = program_.step[i];
    const Factor self{i}, a{step.a}, b{step.b}, slopes{step.a, true};
    if (step.op == Op::product) step.sum = convolve(a, b);
    if (step.op == Op::quotient) step.sum = convolve(b, self);
    if (step.op == Op::root) step.sum = convolve(self, self);
    if (step.op == Op::exponential) step.sum = convolve(slopes, self);
    if (step.op == Op::sine || step.op == Op::cosine) step.sum = convolve(slopes, b);
    if (step.op == Op::power) {
      step.sum = convolve(slopes, self);
      step.other_sum = convolve(a, self);
    }
  }

  Recording recording_;
  Program program_ = {};
  int step_of_[Recording::limit] = {}, fixed_of_[Recording::limit] = {}, uses_[Recording::limit] = {};
};

/// Runs a field on symbols.
template <class Field>
constexpr Program compile() {
  Recording recording;
  States<Field, Symbol> x{};
  Parameters<Field, Symbol> p{};
  for (int i = 0; i < states_of<Field>; ++i) x[i] = Symbol(recording, recording.make_state(i));
  for (int i = 0; i < Field::parameters; ++i) p[i] = Symbol(recording, recording.make_parameter(i));
  const Values<Field, Symbol> row = Field::rates(x, p);
  int node[rows_of<Field>] = {};
  for (int i = 0; i < rows_of<Field>; ++i) node[i] = row[i].node_in(recording);
  return Compiler(recording).run(node, states_of<Field>, rows_of<Field>);
}

/// The program of a field.
template <class Field>
inline constexpr Program program = compile<Field>();

}  // namespace mariotte::series
