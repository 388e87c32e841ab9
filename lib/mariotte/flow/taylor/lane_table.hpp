// Rows of numbers, one number per lane.
#pragma once

namespace mariotte::flow::taylor {

/// Rows of equal length that grow. Every row starts at a boundary of vector registers, and holds as many
/// numbers as whole registers need.
class LaneTable {
 public:
  explicit LaneTable(int rows) : rows_(rows) {}
  LaneTable(LaneTable&& other) noexcept;
  LaneTable& operator=(LaneTable&&) = delete;
  ~LaneTable();

  /// Room for `lanes` numbers in each row. True if the rows have moved: all numbers are zero then.
  bool reserve(int lanes);
  /// Make numbers first … last − 1 of each row zero.
  void clear(int first, int last);
  double* row(int i) const { return data_ + static_cast<long>(i) * room_; }

 private:
  int rows_, room_ = 0;
  double* data_ = nullptr;
};

}  // namespace mariotte::flow::taylor
