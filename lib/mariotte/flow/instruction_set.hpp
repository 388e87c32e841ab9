// What is compiled once per instruction set, and chosen when the program runs. All of it is inlined by force:
// of inline functions in several sources the linker takes any, also one for another processor.
#pragma once

namespace mariotte::flow {

/// With FMA.
[[gnu::always_inline]] inline bool has_avx2() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
#else
  return false;
#endif
}

#ifdef __x86_64__
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
  [[gnu::always_inline]] inline Result function parameters {                  \
    return MARIOTTE_WIDEST(function) arguments;                               \
  }

}  // namespace mariotte::flow
