// Slopes as series, for one instruction set: included by one source file for each, which names the namespace.
#pragma once
#include "mariotte/impact/sensitivity/push_pack.hpp"

namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET {

class Expansion final : public PushExpansion {
 public:
  double expand(const PushSeries& series, const Start& start, const Bound& bound, End end) override {
    forces_.expand(series, start);
    double stop = series.end;
    for (Index first = 0; first < start.velocity.columns;) {
      const auto carry = [&]<class Series>(std::unique_ptr<Series>& pack) {
        if (!pack) pack = std::make_unique<Series>();
        const double reached = pack->expand(forces_, start, first, stop, bound, end);
        first += Series::Pack::count;
        return reached;
      };
      const Index left = start.velocity.columns - first;
      const bool is_first = first == 0;
      const double reached = left == 1          ? carry(lone_)
                             : left <= four     ? carry(one_)
                             : left <= 2 * four ? carry(two_)
                             : left <= 3 * four ? carry(three_)
                                                : carry(four_);
      if (reached == 0) return 0;
      if (reached < stop && !is_first) first = 0;  // those before must stop there, too
      stop = reached;
    }
    return stop;
  }

 private:
  static constexpr int four = 4, unit = four / registers::width;
  Forces forces_;
  // Made when they are needed first.
  std::unique_ptr<PackSeries<0>> lone_;
  std::unique_ptr<PackSeries<unit>> one_;
  std::unique_ptr<PackSeries<2 * unit>> two_;
  std::unique_ptr<PackSeries<3 * unit>> three_;
  std::unique_ptr<PackSeries<4 * unit>> four_;
};

}  // namespace mariotte::impact::MARIOTTE_INSTRUCTION_SET

std::unique_ptr<mariotte::impact::PushExpansion>
mariotte::impact::MARIOTTE_INSTRUCTION_SET::make_push_expansion() {
  return std::make_unique<Expansion>();
}
