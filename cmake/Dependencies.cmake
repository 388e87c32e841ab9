# The library itself stands on SUNDIALS, Eigen and SuiteSparse alone; the rest serves the command and the tests.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(SUNDIALS 6.4 REQUIRED COMPONENTS cvode nvecserial sunlinsolklu)

if(MARIOTTE_APPS OR MARIOTTE_TESTS)
  find_package(fmt REQUIRED)
  find_package(nlohmann_json REQUIRED)
  find_package(tomlplusplus REQUIRED)
endif()
if(MARIOTTE_APPS)
  find_package(CLI11 REQUIRED)
  if(MARIOTTE_MPI)
    set(MPI_CXX_SKIP_MPICXX TRUE)
    find_package(MPI QUIET COMPONENTS CXX)
  endif()
  find_package(Boost REQUIRED)  # odeint, a rival in work_precision; headers only
endif()
