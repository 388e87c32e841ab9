// Counts what is allocated; for one source file of a test.
#pragma once
#include <cstdlib>
#include <new>
#include <vector>

#include "mariotte/hybrid/options.hpp"

// The operators below are a matching pair, which the compiler fails to see once they are inlined.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

namespace {
long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto unit = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(unit, (size + unit - 1) / unit * unit)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace mariotte::test {

/// Allocations of a second round over models that a first round has seen.
template <class Solver, class Model>
long allocations_when_repeated(const std::vector<Model>& models, const hybrid::Options& options) {
  Solver solver;
  for (const auto& model : models) solver.solve(model, options);
  const long before = allocations;
  for (const auto& model : models) solver.solve(model, options);
  return allocations - before;
}

}  // namespace mariotte::test
