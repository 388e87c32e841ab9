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

/// Registers of eight that pay: Zen 4 takes them in two halves; before Ice Lake they slow the clock.
[[gnu::always_inline]] inline bool has_avx512() {
#ifdef __x86_64__
  return __builtin_cpu_supports("avx512vbmi") && !__builtin_cpu_is("amdfam19h");
#else
  return false;
#endif
}

#ifdef __x86_64__
#define MARIOTTE_WIDEST(function) (mariotte::flow::has_avx2() ? avx2::function : baseline::function)
#define MARIOTTE_WIDEST_OF_ALL(function) \
  (mariotte::flow::has_avx512() ? avx512::function : MARIOTTE_WIDEST(function))
#else
#define MARIOTTE_WIDEST(function) baseline::function
#define MARIOTTE_WIDEST_OF_ALL(function) baseline::function
#endif

#define MARIOTTE_IN(set, Result, function, parameters) \
  namespace set {                                      \
  Result function parameters;                          \
  }
#define MARIOTTE_BY(choice, Result, function, parameters, arguments) \
  MARIOTTE_IN(avx2, Result, function, parameters)                    \
  MARIOTTE_IN(baseline, Result, function, parameters)                \
  [[gnu::always_inline]] inline Result function parameters {         \
    return choice(function) arguments;                               \
  }

/// Declares a function for each set, in its namespace, and one that takes the widest registers of this
/// machine.
#define MARIOTTE_PER_INSTRUCTION_SET(Result, function, parameters, arguments) \
  MARIOTTE_BY(MARIOTTE_WIDEST, Result, function, parameters, arguments)

/// The same with AVX-512 among them.
#define MARIOTTE_PER_WIDE_INSTRUCTION_SET(Result, function, parameters, arguments) \
  MARIOTTE_IN(avx512, Result, function, parameters)                                \
  MARIOTTE_BY(MARIOTTE_WIDEST_OF_ALL, Result, function, parameters, arguments)

}  // namespace mariotte::flow
