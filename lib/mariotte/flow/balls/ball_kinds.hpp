// The series of contacts of balls, one for each kind; compiled once per instruction set.
#pragma once
#include <cstring>
#include <utility>
#include <variant>

#include "mariotte/flow/balls/ball_expansions.hpp"
#include "mariotte/series/series.hpp"

namespace mariotte::flow::balls::MARIOTTE_INSTRUCTION_SET {

inline constexpr int width = MARIOTTE_VECTOR_BYTES / 8;
typedef double Pack __attribute__((vector_size(MARIOTTE_VECTOR_BYTES), aligned(8), may_alias));

template <Grip grip, bool pair>
struct Field : BallField<grip, pair> {
  static constexpr int packed = width;
};

template <int which>
struct Expansion : series::Series<Field<static_cast<Grip>(which / 2), which % 2 == 1>,
                                  BallExpansions::most_order, double> {
  Expansion() {}  // leaves most of its memory as it is
};

template <int... which>
auto any_of(std::integer_sequence<int, which...>) -> std::variant<std::monostate, Expansion<which>...>;
using Kinds = std::make_integer_sequence<int, 2 * grips>;

/// Has room for one at a time.
class Expansions final : public BallExpansions {
 public:
  void expand(const BallContact& contact, const BallPhase::Motion& start, int order) override {
    const int wanted = 2 * static_cast<int>(contact.grip) + (contact.pair ? 1 : 0);
    order_ = order;
    [&]<int... which>(std::integer_sequence<int, which...>) {
      ((which == wanted && (row_ = expand<which>(contact, start))), ...);
    }
    (Kinds());
  }

  BallPhase::Motion at(double place) const override {
    constexpr int most = BallExpansions::most_order + 2;
    double power[most] = {1, place};  // beyond the order they are 0
    const double square = place * place;
    for (int k = 2; k <= order_; ++k) power[k] = power[k - 2] * square;
    Pack packed[most / width];
    std::memcpy(packed, power, sizeof power);
    BallPhase::Motion sum = {};
    for (int i = 0; i < BallMotion::states; ++i) {
      Pack some{};
      series::unrolled<most / width>([&](auto j) MARIOTTE_SERIES_LAMBDA {
        some += *reinterpret_cast<const Pack*>(&row_[i][j * width]) * packed[j];
      });
      for (int lane = 0; lane < width; ++lane) sum[i] += some[lane];
    }
    return sum;
  }

 private:
  template <int which>
  const Row* expand(const BallContact& contact, const BallPhase::Motion& start) {
    if (one_.index() != which + 1) one_.template emplace<which + 1>();
    auto& expansion = *std::get_if<which + 1>(&one_);
    expansion.expand(start, contact.parameter, order_);
    return &expansion[0];
  }

  decltype(any_of(Kinds())) one_;
};

}  // namespace mariotte::flow::balls::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::flow::BallExpansions>
mariotte::flow::MARIOTTE_INSTRUCTION_SET::make_ball_expansions() {
  return std::unique_ptr<BallExpansions>(new balls::MARIOTTE_INSTRUCTION_SET::Expansions);
}
