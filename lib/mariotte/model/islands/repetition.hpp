// What happens in one place of a chain again and again, farther and farther on.
#pragma once
#include <algorithm>
#include <iterator>
#include <vector>

#include "mariotte/core/types.hpp"

namespace mariotte::model {

/// A wave among balls `first` to `last`, which does to the next `shift` balls what it did to those before.
struct Repetition {
  Index first, last;
  Index shift;    ///< balls that it passes in a period; negative towards the start of the chain
  double period;  ///< time that it takes
  Index count;    ///< periods that follow

  Index way() const { return shift * count; }
};

/// Values along a chain after the wave, which holds `from` to `to` − 1 of them, has moved on: its own stand
/// `way` farther, and those that it leaves behind are as they were `shift` before. `later(value, periods)`
/// makes a value older.
template <class Value, class Later>
void repeat(std::vector<Value>& values, Index from, Index to, Index shift, Index count, Later&& later) {
  const Index way = shift * count;
  std::vector<Value> wave(values.begin() + from, values.begin() + to);
  for (Index i = from; i < from + way; ++i) values[i] = later(values[i - shift], 1);
  for (Index i = to - 1; i >= to + way; --i) values[i] = later(values[i - shift], 1);
  std::transform(wave.begin(), wave.end(), values.begin() + from + way,
                 [&](const Value& value) { return later(value, count); });
}

/// The same of values of the contacts that do not grow older.
template <class Value>
void repeat(std::vector<Value>& values, const Repetition& of) {
  repeat(values, of.first, of.last, of.shift, of.count, [](const Value& value, Index) { return value; });
}

}  // namespace mariotte::model
