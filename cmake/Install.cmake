# What an installation holds: the library with its headers, the command, and the package for find_package(mariotte).
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mariotte)

install(TARGETS mariotte EXPORT mariotteTargets)
list(JOIN MARIOTTE_PRIVATE_HEADERS "|" private_headers)
foreach(module IN LISTS MARIOTTE_LIBRARY_MODULES)
  install(DIRECTORY lib/mariotte/${module} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/mariotte
          FILES_MATCHING PATTERN "*.hpp" REGEX "/(${private_headers})[^/]*\\.hpp$" EXCLUDE)
endforeach()
if(MARIOTTE_APPS)
  install(TARGETS mariotte_command icr_table scaling_study stiffness_study stress_study work_precision)
endif()

configure_package_config_file(cmake/mariotteConfig.cmake.in mariotteConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(mariotteConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mariotteConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/mariotteConfigVersion.cmake
        DESTINATION ${package_dir})
install(EXPORT mariotteTargets NAMESPACE mariotte:: DESTINATION ${package_dir})
