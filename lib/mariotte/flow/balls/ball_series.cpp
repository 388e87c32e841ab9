#include "mariotte/flow/balls/ball_series.hpp"

#include <tuple>
#include <utility>

#include "mariotte/series/series.hpp"

namespace mariotte::flow {
namespace {

using Row = std::array<double, BallSeries::most_order + 2>;

template <int which>
using Expansion =
    series::Series<BallField<static_cast<Grip>(which / 2), which % 2 == 1>, BallSeries::most_order, double>;

/// Memory of an expansion, made when it is first used.
template <int which>
struct Room {
  std::unique_ptr<Expansion<which>> expansion;

  const Row* expand(const BallContact& contact, const BallPhase::Motion& start, int order) {
    if (!expansion) expansion = std::make_unique<Expansion<which>>();
    expansion->expand(start, contact.parameter, order);
    return &(*expansion)[0];
  }
};

template <int... which>
auto rooms(std::integer_sequence<int, which...>) -> std::tuple<Room<which>...>;
using Which = std::make_integer_sequence<int, 2 * grips>;

}  // namespace

struct BallSeries::Memory {
  decltype(rooms(Which())) room;
};

BallSeries::BallSeries() : memory_(std::make_unique<Memory>()) {}
BallSeries::~BallSeries() = default;

void BallSeries::expand(const BallContact& contact, const BallPhase::Motion& start, int order) {
  const int wanted = 2 * static_cast<int>(contact.grip) + (contact.pair ? 1 : 0);
  order_ = order;
  [&]<int... which>(std::integer_sequence<int, which...>) {
    ((which == wanted && (row_ = std::get<which>(memory_->room).expand(contact, start, order))), ...);
  }
  (Which());
}

BallPhase::Motion BallSeries::at(double place) const {
  BallPhase::Motion sum = {};
  for (int k = order_; k >= 0; --k)
    for (int i = 0; i < BallMotion::states; ++i) sum[i] = sum[i] * place + row_[i][k];
  return sum;
}

}  // namespace mariotte::flow
