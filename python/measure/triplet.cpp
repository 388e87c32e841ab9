// The processor time of one triplet in C++ [µs], to stand beside that from Python: `simulate` and the
// quickest solver.
#include <cstdio>
#include <ctime>

#include "mariotte/mariotte.hpp"

namespace {

template <class Solve>
double microseconds(const Solve& solve) {
  constexpr int runs = 20000;
  const auto start = std::clock();
  for (int i = 0; i < runs; ++i) solve();
  return 1e6 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC / runs;
}

}  // namespace

int main() {
  using mariotte::contact::Hertz;
  const mariotte::model::Chain triplet{
      .mass = {1, 1, 1}, .law = {Hertz{1}, Hertz{1}}, .gap = {0, 0}, .velocity = {1, 0, 0}};
  mariotte::impact::ChainSolver solver;
  std::printf("%.3f %.3f\n", microseconds([&] { solver.solve(triplet); }),
              microseconds([&] { mariotte::impact::simulate(triplet); }));
}
