// Places for words in a figure, where no two cover each other.
#pragma once
#include <string>
#include <vector>

namespace mariotte::report {

/// Heights of words in a column, as near to the wanted ones as can be (least squares) in the same order, with
/// `space` between neighbours, one value per word, and within 0 … 1 if there is room. All in the same unit.
std::vector<double> spread(const std::vector<double>& wanted, const std::vector<double>& space);

/// A rectangle from its lower left corner.
struct Box {
  double x;
  double y;
  double width;
  double height;
};

/// `box`, or the nearest place above it, within height 1, or else below it, that is free of `taken`.
Box free_place(Box box, const std::vector<Box>& taken);

/// The same with a shift of up to half its width to a side, within 0 … 1, where that is the shorter way; free
/// of `curves`, too, if there is such a place.
Box free_place(const Box& box, const std::vector<Box>& taken, const std::vector<Box>& curves);

/// Which of several rows, one above the other, holds each word centred at `at` that is `width` wide: 0 is the
/// lowest; −1 means that no row has room. Words come in the order of `at`.
std::vector<int> rows_of_words(const std::vector<double>& at, const std::vector<double>& width, int rows);

}  // namespace mariotte::report
