# mariotte_warnings(<target>): the warnings this project is written without.
function(mariotte_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                         $<$<BOOL:${MARIOTTE_WERROR}>:-Werror>)
  if(MARIOTTE_SANITIZE)
    target_compile_options(${target} PUBLIC -fsanitize=${MARIOTTE_SANITIZE} -fno-omit-frame-pointer
                           -fno-sanitize-recover=all)
    target_link_options(${target} PUBLIC -fsanitize=${MARIOTTE_SANITIZE})
  endif()
endfunction()
