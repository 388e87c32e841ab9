// What is compiled once per instruction set, and chosen when the program runs.
#pragma once

namespace mariotte::flow {

#ifdef __x86_64__
/// With FMA.
inline bool has_avx2() {
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#define MARIOTTE_WIDEST(function) (mariotte::flow::has_avx2() ? avx2::function : baseline::function)
#else
#define MARIOTTE_WIDEST(function) baseline::function
#endif

/// Declares a function for each set, in its namespace, and one that takes the widest registers of this
/// machine.
#define MARIOTTE_PER_INSTRUCTION_SET(Result, function, parameters, arguments) \
  namespace avx2 {                                                            \
  Result function parameters;                                                 \
  }                                                                           \
  namespace baseline {                                                        \
  Result function parameters;                                                 \
  }                                                                           \
  inline Result function parameters {                                         \
    return MARIOTTE_WIDEST(function) arguments;                               \
  }

}  // namespace mariotte::flow
