# What an installation holds: the library with its public headers, the component `scene`, the command, and the
# package for find_package(mariotte).
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/mariotte)
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/mariotte)
set(generated ${PROJECT_BINARY_DIR}/include/mariotte)

function(mariotte_install_headers)
  foreach(header IN LISTS ARGN)
    get_filename_component(folder ${header} DIRECTORY)
    install(FILES lib/mariotte/${header} DESTINATION ${header_dir}/${folder})
  endforeach()
endfunction()

install(TARGETS mariotte EXPORT mariotteTargets)
mariotte_install_headers(${MARIOTTE_PUBLIC_HEADERS})
install(FILES ${generated}/mariotte.hpp ${generated}/version.hpp DESTINATION ${header_dir})
install(EXPORT mariotteTargets NAMESPACE mariotte:: DESTINATION ${package_dir})
if(TARGET mariotte::scene)
  install(TARGETS mariotte_tools EXPORT mariotteSceneTargets)
  mariotte_install_headers(${MARIOTTE_SCENE_HEADERS})
  install(FILES ${generated}/scene.hpp DESTINATION ${header_dir})
  install(EXPORT mariotteSceneTargets NAMESPACE mariotte:: DESTINATION ${package_dir})
endif()
if(MARIOTTE_APPS)
  install(TARGETS mariotte_command icr_table paper_figures scaling_study stiffness_study stress_study work_precision)
endif()

configure_package_config_file(cmake/mariotteConfig.cmake.in mariotteConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(mariotteConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/mariotteConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/mariotteConfigVersion.cmake
        DESTINATION ${package_dir})
