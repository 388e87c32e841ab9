// The number that a field is run on to be recorded.
#pragma once
#include "mariotte/series/recording.hpp"

namespace mariotte::series {

/// A node of a recording, or a plain number that no recording knows yet.
class Symbol {
 public:
  constexpr Symbol() = default;
  constexpr Symbol(double number) : number_(number) {}
  constexpr Symbol(Recording& recording, int node) : recording_(&recording), node_(node), number_(1) {}

  constexpr int node_in(Recording& recording) const {
    return recording_ ? node_ : recording.make_number(number_);
  }

  friend constexpr Symbol operator+(const Symbol& a, const Symbol& b) {
    return binary(a, b, &Recording::make_sum, a.number_ + b.number_);
  }
  friend constexpr Symbol operator*(const Symbol& a, const Symbol& b) {
    return binary(a, b, &Recording::make_product, a.number_ * b.number_);
  }
  friend constexpr Symbol operator/(const Symbol& a, const Symbol& b) {
    return binary(a, b, &Recording::make_quotient, a.number_ / b.number_);
  }
  friend constexpr Symbol operator-(const Symbol& a) { return Symbol(-1) * a; }
  friend constexpr Symbol operator-(const Symbol& a, const Symbol& b) { return a + -b; }
  friend constexpr Symbol sqrt(const Symbol& a) {
    return a.with(a.recording_->make_unary(Op::root, a.node_));
  }
  friend constexpr Symbol exp(const Symbol& a) {
    return a.with(a.recording_->make_unary(Op::exponential, a.node_));
  }
  friend constexpr Symbol sin(const Symbol& a) { return a.with(a.recording_->make_turn(a.node_)); }
  friend constexpr Symbol cos(const Symbol& a) { return a.with(a.recording_->make_turn(a.node_) + 1); }
  friend constexpr Symbol pow(const Symbol& a, const Symbol& exponent) {
    return a.with(a.recording_->make_power(a.node_, exponent.node_in(*a.recording_)));
  }
  /// Linear map number `which` of those that whoever expands the field supplies.
  template <int which>
  friend constexpr Symbol map(const Symbol& a) {
    return a.with(a.recording_->make_map(a.node_, which));
  }

 private:
  constexpr Symbol with(int node) const { return {*recording_, node}; }
  static constexpr Symbol binary(const Symbol& a, const Symbol& b, int (Recording::*make)(int, int),
                                 double of_numbers) {
    Recording* recording = a.recording_ ? a.recording_ : b.recording_;
    if (!recording) return of_numbers;
    return {*recording, (recording->*make)(a.node_in(*recording), b.node_in(*recording))};
  }

  Recording* recording_ = nullptr;
  int node_ = -1;
  double number_ = 0;  ///< of a node, 1: the arithmetic of plain numbers is done beside
};

}  // namespace mariotte::series
