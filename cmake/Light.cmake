# mariotte_light(<target>): nothing in it takes time when it runs, so it shall not take long to compile.
function(mariotte_light target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
