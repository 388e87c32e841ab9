// The time of one triplet in C++ [µs], to stand beside that from Python: `simulate` and the quickest solver.
#include <chrono>
#include <cstdio>

#include "mariotte/mariotte.hpp"

namespace {

template <class Solve>
double microseconds(const Solve& solve) {
  constexpr int runs = 20000;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < runs; ++i) solve();
  const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - start;
  return taken.count() / runs;
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
