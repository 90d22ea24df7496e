# `cmake --install`: libraries and headers for find_package(b4p), the b4p command, robots and scenes.
include(CMakePackageConfigHelpers)

set(b4p_rooms robots state_validity planners)
set(b4p_targets b4p_robots b4p_state_validity b4p_planners)
if(B4P_BUILD_EXPERIMENTS)
  list(APPEND b4p_rooms experiments)
  foreach(target IN ITEMS b4p_verification b4p_planar_proof b4p_experiments b4p)
    if(TARGET ${target})
      list(APPEND b4p_targets ${target})
    endif()
  endforeach()
endif()

install(TARGETS ${b4p_targets} EXPORT b4pTargets)
foreach(room IN LISTS b4p_rooms)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/b4p
          FILES_MATCHING PATTERN "*.h" PATTERN examples EXCLUDE)
endforeach()

set(b4p_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/b4p)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/b4pConfig.cmake.in ${PROJECT_BINARY_DIR}/b4pConfig.cmake
                              INSTALL_DESTINATION ${b4p_package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/b4pConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/b4pConfig.cmake ${PROJECT_BINARY_DIR}/b4pConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/B4pDependencies.cmake
        DESTINATION ${b4p_package_dir})
install(EXPORT b4pTargets NAMESPACE b4p:: DESTINATION ${b4p_package_dir})

install(DIRECTORY ${PROJECT_SOURCE_DIR}/robots DESTINATION ${CMAKE_INSTALL_DATADIR}/b4p
        FILES_MATCHING PATTERN "*.yaml" PATTERN "*.urdf")
if(B4P_BUILD_EXPERIMENTS)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/experiments/scenes
          DESTINATION ${CMAKE_INSTALL_DATADIR}/b4p/experiments OPTIONAL)
endif()
