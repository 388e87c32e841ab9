# The interpreter that the Python module is for, and pybind11. Without either pybind11_FOUND is false.
# The first interpreter that has NumPy is taken: one that pyenv or conda puts before it may have none.
foreach(candidate IN ITEMS "${Python_EXECUTABLE}" python3 /usr/bin/python3)
  execute_process(COMMAND "${candidate}" -c "import sys, numpy; print(sys.executable)" OUTPUT_VARIABLE found
                  OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(found)
    set(Python_EXECUTABLE "${found}" CACHE FILEPATH "Interpreter that the Python module is for" FORCE)
    find_package(Python 3.9 QUIET COMPONENTS Interpreter Development.Module)
    find_package(pybind11 2.10 QUIET)
    break()
  endif()
endforeach()
if(NOT pybind11_FOUND)
  message(STATUS "No Python module: it needs pybind11, and an interpreter with NumPy and headers")
endif()
