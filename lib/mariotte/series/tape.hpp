// A field recorded while it is evaluated: run on `Traced` numbers, it leaves its operations on a tape, in the
// order in which they can be repeated. For fields whose shape is known at run time only.
#pragma once
#include <cmath>
#include <vector>

#include "mariotte/core/types.hpp"
#include "mariotte/core/width_branch.hpp"

namespace mariotte::series {

/// What a place on the tape does with earlier places a and b, or with a number.
enum class TapeOp : unsigned char {
  constant,
  state,
  sum,
  difference,
  product,
  quotient,
  root,
  sine,
  cosine,           ///< the place after its sine
  width,            ///< w with w⁴ − w = a, the larger one
  square_of_width,  ///< the place after it
  offset,           ///< a + number
  scaled,           ///< number × a
  onset             ///< a, which is exactly 0 where a contact begins
};

/// One operation.
struct TapeNode {
  TapeOp op;
  int a = -1, b = -1;
  double number = 0;
  bool operator==(const TapeNode&) const = default;
};

/// Operations, each of them once.
class Tape {
 public:
  void clear();
  Index size() const { return std::ssize(nodes_); }
  const TapeNode& operator[](Index i) const { return nodes_[i]; }
  /// The place of this operation, a new one if it is not there yet.
  int put(const TapeNode& node);

 private:
  int append(const TapeNode& node);
  void grow();

  std::vector<TapeNode> nodes_;
  std::vector<int> slots_;  ///< places by hash; −1: free
};

/// A number that knows where on a tape it was computed; a constant is on none.
class Traced {
 public:
  Traced() = default;
  Traced(double constant) : value_(constant) {}
  Traced(Tape& tape, int place, double value) : tape_(&tape), place_(place), value_(value) {}

  double value() const { return value_; }
  bool is_constant() const { return !tape_; }
  /// Its place, on this tape.
  int place_on(Tape& tape) const {
    return tape_ ? place_ : tape.put({.op = TapeOp::constant, .number = value_});
  }

  friend Traced operator+(const Traced& a, const Traced& b) {
    if (!a.tape_) return b.shifted(a.value_);
    if (!b.tape_) return a.shifted(b.value_);
    return a.with({TapeOp::sum, std::min(a.place_, b.place_), std::max(a.place_, b.place_)},
                  a.value_ + b.value_);
  }
  friend Traced operator-(const Traced& a, const Traced& b) {
    if (!a.tape_) return (-b).shifted(a.value_);
    if (!b.tape_) return a.shifted(-b.value_);
    return a.with({TapeOp::difference, a.place_, b.place_}, a.value_ - b.value_);
  }
  friend Traced operator-(const Traced& a) { return a.times(-1); }
  friend Traced operator*(const Traced& a, const Traced& b) {
    if (!a.tape_) return b.times(a.value_);
    if (!b.tape_) return a.times(b.value_);
    return a.with({TapeOp::product, std::min(a.place_, b.place_), std::max(a.place_, b.place_)},
                  a.value_ * b.value_);
  }
  friend Traced operator/(const Traced& a, const Traced& b) {
    if (!b.tape_) return a.times(1 / b.value_);
    return b.with({TapeOp::quotient, a.place_on(*b.tape_), b.place_}, a.value_ / b.value_);
  }
  friend Traced sqrt(const Traced& a) { return a.by(TapeOp::root, std::sqrt(a.value_)); }
  friend Traced sin(const Traced& a) { return a.by(TapeOp::sine, std::sin(a.value_)); }
  friend Traced cos(const Traced& a) {
    auto result = sin(a);
    if (result.tape_) ++result.place_;
    result.value_ = std::cos(a.value_);
    return result;
  }
  friend Traced width_of(const Traced& a) {
    return a.by(TapeOp::width, WidthCurve{.radius = 1, .s = 1}.root(a.value_));
  }
  /// The same, which is exactly 0 where a contact begins.
  friend Traced at_onset(const Traced& a) { return a.by(TapeOp::onset, 0); }
  friend bool operator<(const Traced& a, double b) { return a.value_ < b; }
  friend bool operator>(const Traced& a, double b) { return a.value_ > b; }

 private:
  Traced with(const TapeNode& node, double value) const { return {*tape_, tape_->put(node), value}; }
  Traced by(TapeOp op, double value) const { return tape_ ? with({op, place_}, value) : Traced(value); }
  Traced shifted(double by) const {
    if (!tape_) return value_ + by;
    return by == 0 ? *this : with({TapeOp::offset, place_, -1, by}, value_ + by);
  }
  Traced times(double by) const {
    if (!tape_) return value_ * by;
    if (by == 0) return 0.0;
    return by == 1 ? *this : with({TapeOp::scaled, place_, -1, by}, value_ * by);
  }

  Tape* tape_ = nullptr;
  int place_ = -1;
  double value_ = 0;
};

/// Without its place.
inline double value_of(const Traced& a) {
  return a.value();
}

}  // namespace mariotte::series
