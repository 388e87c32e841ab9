# How many times as long programs may take in this build: sanitizers slow them down.
set(mariotte_slowdown 1)
if(MARIOTTE_SANITIZE)
  set(mariotte_slowdown 10)
endif()

# mariotte_scaled(<variable> <seconds>): that many seconds in a build without sanitizers.
function(mariotte_scaled variable seconds)
  math(EXPR scaled "${seconds} * ${mariotte_slowdown}")
  set(${variable} ${scaled} PARENT_SCOPE)
endfunction()

# mariotte_time_limit(<seconds> <test>...): after which a test has failed.
function(mariotte_time_limit seconds)
  mariotte_scaled(limit ${seconds})
  set_tests_properties(${ARGN} PROPERTIES TIMEOUT ${limit})
endfunction()
