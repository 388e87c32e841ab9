# mariotte_warnings(<target>): the warnings this project is written without.
function(mariotte_warnings target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    target_compile_options(${target} PRIVATE -Wno-restrict)  # false alarm on "text" + string, GCC bug 105651
    if(MARIOTTE_SANITIZE)  # its checks hide from the compiler what is initialised
      target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)
    endif()
  endif()
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                         $<$<BOOL:${MARIOTTE_WERROR}>:-Werror>)
  if(MARIOTTE_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=${MARIOTTE_SANITIZE} -fno-omit-frame-pointer
                           -fno-sanitize-recover=all)
    target_compile_definitions(${target} PUBLIC _GLIBCXX_ASSERTIONS MARIOTTE_SERIES_CALLS)
    target_link_options(${target} PUBLIC -fsanitize=${MARIOTTE_SANITIZE})
  endif()
endfunction()
