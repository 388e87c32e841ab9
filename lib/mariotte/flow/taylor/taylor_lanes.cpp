#include "mariotte/flow/taylor/taylor_lanes.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "mariotte/flow/instruction_set.hpp"

namespace mariotte::flow::taylor {
namespace {

constexpr int whole = 16;  ///< lanes are expanded in blocks of this many or fewer
constexpr std::align_val_t boundary{64};

}  // namespace

LaneTable::LaneTable(LaneTable&& other) noexcept
    : rows_(other.rows_), room_(std::exchange(other.room_, 0)), data_(std::exchange(other.data_, nullptr)) {}

LaneTable::~LaneTable() {
  ::operator delete(data_, boundary);
}

bool LaneTable::reserve(int lanes) {
  if (data_ && lanes <= room_) return false;
  ::operator delete(data_, boundary);
  room_ = std::max((lanes + whole - 1) / whole * whole, most_row_limit);
  const auto size = static_cast<std::size_t>(rows_) * room_;
  data_ = static_cast<double*>(::operator new(size * sizeof(double), boundary));
  std::fill_n(data_, size, 0.0);
  return true;
}

void LaneTable::clear(int first, int last) {
  for (int i = 0; first < last && i < rows_; ++i) std::fill(row(i) + first, row(i) + last, 0.0);
}

Lanes::Lanes() : table_(27) {
  resize(0);
}

void Lanes::resize(int lanes) {
  if (table_.reserve(lanes)) {
    count = 0;
    int i = 0;
    for (double** row :
         {&indentation, &rate,       &width,      &active,      &acts_above,   &late_above, &rooted,
          &stiffness,   &steepening, &damping,    &stiffening,  &ring,         &power,      &left,
          &right,       &drive,      &side,       &level,       &leeway,       &load_side,  &yield_side,
          &yield_level, &turn_side,  &turn_level, &fades_below, &leaves_noise, &weight})
      *row = table_.row(i++);
  }
  table_.clear(lanes, count);
  count = lanes;
}

Values::Values() : table_(7) {
  resize(0);
}

void Values::resize(int lanes) {
  if (!table_.reserve(lanes)) return;
  int i = 0;
  for (double** row : {&indentation, &impulse, &work, &width, &margin, &load_margin, &branch_margin})
    *row = table_.row(i++);
}

std::size_t size_for(const Lanes& lanes) {
  if (is_in_blocks(lanes)) return lane_sizes.size();
  return std::lower_bound(lane_sizes.begin(), lane_sizes.end(), lanes.count) - lane_sizes.begin();
}

}  // namespace mariotte::flow::taylor
