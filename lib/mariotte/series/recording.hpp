// What is recorded when a field is run on symbols instead of numbers: its operations, each one once.
//
// A node is constant if only numbers and parameters enter it. −x is (−1) x and a − b is a + (−1) b, so that
// what is linear is made of `sum` and of products with a constant first factor alone.
#pragma once
#include <utility>

namespace mariotte::series {

enum class Op : unsigned char {
  state,
  parameter,
  number,
  sum,
  product,
  quotient,
  root,
  power,
  exponential,
  sine,
  cosine,
  map
};

/// One operation; a and b are earlier nodes, or the place of a state or parameter, or which map.
struct Node {
  Op op;
  int a = -1, b = -1;
  double number = 0;
  bool constant = false;
  constexpr bool operator==(const Node&) const = default;
};

/// Nodes in the order in which they can be evaluated. Each `make` gives the place of its result.
class Recording {
 public:
  static constexpr int limit = 400;

  constexpr const Node& operator[](int i) const { return nodes_[i]; }
  constexpr int size() const { return size_; }
  constexpr bool is_constant(int i) const { return nodes_[i].constant; }
  constexpr bool is_number(int i) const { return nodes_[i].op == Op::number; }
  constexpr bool is_number(int i, double value) const { return is_number(i) && nodes_[i].number == value; }
  /// A product with a constant, which stands first.
  constexpr bool is_scaled(int i) const {
    return nodes_[i].op == Op::product && !nodes_[i].constant && nodes_[nodes_[i].a].constant;
  }

  constexpr int make_number(double value) { return put({Op::number, -1, -1, value, true}); }
  constexpr int make_parameter(int place) { return put({Op::parameter, place, -1, 0, true}); }
  constexpr int make_state(int place) { return put({Op::state, place}); }
  constexpr int make_map(int a, int which) { return put({Op::map, a, which}); }
  constexpr int make_unary(Op op, int a) { return put({op, a, -1, 0, is_constant(a)}); }

  constexpr int make_sum(int a, int b) {
    if (is_number(a, 0)) return b;
    if (is_number(b, 0)) return a;
    if (is_number(a) && is_number(b)) return make_number(nodes_[a].number + nodes_[b].number);
    if (a > b) std::swap(a, b);
    return put({Op::sum, a, b, 0, is_constant(a) && is_constant(b)});
  }

  constexpr int make_product(int a, int b) {
    if (is_constant(a) && is_constant(b)) return constant_product(a, b);
    if (is_constant(b)) std::swap(a, b);
    if (is_constant(a)) return scaled(a, b);
    if (is_scaled(a)) return scaled(nodes_[a].a, make_product(nodes_[a].b, b));
    if (is_scaled(b)) return scaled(nodes_[b].a, make_product(a, nodes_[b].b));
    if (a > b) std::swap(a, b);
    return put({Op::product, a, b});
  }

  constexpr int make_quotient(int a, int b) {
    if (is_number(a) && is_number(b)) return make_number(nodes_[a].number / nodes_[b].number);
    if (is_constant(a) && is_constant(b)) return put({Op::quotient, a, b, 0, true});
    if (is_constant(b)) return scaled(make_quotient(make_number(1), b), a);
    if (is_scaled(b)) return make_quotient(make_quotient(a, nodes_[b].a), nodes_[b].b);
    if (is_scaled(a)) return scaled(nodes_[a].a, make_quotient(nodes_[a].b, b));
    if (is_constant(a) && !is_number(a, 1)) return scaled(a, make_quotient(make_number(1), b));
    return put({Op::quotient, a, b});
  }

  constexpr int make_power(int a, int exponent) {
    if (is_number(exponent, 1)) return a;
    if (is_number(exponent, 0.5)) return make_unary(Op::root, a);
    return put({Op::power, a, exponent, 0, is_constant(a)});
  }

  /// Sine and cosine need each other: they are nodes side by side, and this is the place of the sine.
  constexpr int make_turn(int a) {
    const int sine = make_unary(Op::sine, a);
    make_unary(Op::cosine, a);
    return sine;
  }

 private:
  constexpr int put(const Node& node) {
    for (int i = 0; i < size_; ++i)
      if (nodes_[i] == node) return i;
    if (size_ == limit) throw "this field has too many operations";
    nodes_[size_] = node;
    return size_++;
  }

  /// Numbers are gathered in front, so that they become one.
  constexpr int constant_product(int a, int b) {
    if (is_number(b)) std::swap(a, b);
    if (is_number(a, 0) || is_number(a, 1)) return is_number(a, 0) ? a : b;
    if (is_number(a) && is_number(b)) return make_number(nodes_[a].number * nodes_[b].number);
    if (has_number(b))
      return is_number(a) ? constant_product(number_product(a, b), nodes_[b].b) : gathered(b, a);
    if (has_number(a)) return gathered(a, b);
    if (!is_number(a) && a > b) std::swap(a, b);
    return put({Op::product, a, b, 0, true});
  }
  constexpr bool has_number(int i) const { return nodes_[i].op == Op::product && is_number(nodes_[i].a); }
  constexpr int number_product(int a, int b) { return constant_product(a, nodes_[b].a); }
  constexpr int gathered(int with_number, int other) {
    return constant_product(nodes_[with_number].a, constant_product(nodes_[with_number].b, other));
  }

  constexpr int scaled(int factor, int a) {
    if (is_number(factor, 0)) return factor;
    if (is_number(factor, 1)) return a;
    if (is_constant(a)) return constant_product(factor, a);
    if (is_scaled(a)) return scaled(constant_product(factor, nodes_[a].a), nodes_[a].b);
    return put({Op::product, factor, a});
  }

  Node nodes_[limit] = {};
  int size_ = 0;
};

}  // namespace mariotte::series
