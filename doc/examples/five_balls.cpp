// Newton's cradle in units of its own: one ball strikes four that touch at rest.
#include <cstdio>

#include "mariotte/mariotte.hpp"

int main() {
  using mariotte::contact::Hertz;
  const mariotte::model::Chain cradle{
      .mass = {1, 1, 1, 1, 1},
      .law = {Hertz{1}, Hertz{1}, Hertz{1}, Hertz{1}},  // stiffness of f = k δ^{3/2}
      .gap = {0, 0, 0, 0},
      .velocity = {1, 0, 0, 0, 0},
  };
  const auto impact = mariotte::impact::simulate(cradle, {.accuracy = 1e-12});

  std::printf("%s\n", mariotte::hybrid::name(impact.ending));
  for (const double velocity : impact.velocity) std::printf("velocity %13.10f\n", velocity);
  for (const auto& ratio : impact.icr)
    if (ratio) std::printf("ratio    %13.10f\n", *ratio);  // p_j / p_{j+1}, empty where p_{j+1} = 0
}
