# The library itself stands on SUNDIALS, Eigen and SuiteSparse alone; the rest serves the command and the tests.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(SUNDIALS REQUIRED COMPONENTS cvode nvecserial sunlinsolklu)
if(SUNDIALS_VERSION VERSION_LESS 6.4)
  message(FATAL_ERROR "SUNDIALS ${SUNDIALS_VERSION} is too old: 6.4 or newer is needed")
endif()

if(MARIOTTE_APPS OR MARIOTTE_TESTS)
  find_package(fmt REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(tomlplusplus REQUIRED)
  find_package(muparser REQUIRED)  # expressions in sweeps
  find_package(Boost REQUIRED)  # Student's t of fits, and odeint, a rival in work_precision; headers only
  if(MARIOTTE_HDF5)
    find_package(HDF5 QUIET COMPONENTS CXX)
  endif()
endif()
if(MARIOTTE_APPS)
  find_package(CLI11 REQUIRED)
  if(MARIOTTE_MPI)
    set(MPI_CXX_SKIP_MPICXX TRUE)
    find_package(MPI QUIET COMPONENTS CXX)
  endif()
endif()
