# `cmake --install`: the packages permgen (programs, tables, manifest loader, permgen_effect(), permgen_rig()) and tyndall
# (components plan and runtime), found by find_package(permgen) and find_package(tyndall).
include(CMakePackageConfigHelpers)

set_target_properties(permgen_tables PROPERTIES EXPORT_NAME tables)
set_target_properties(permgen_manifest PROPERTIES EXPORT_NAME manifest)
set_target_properties(tyndall_plan PROPERTIES EXPORT_NAME plan)
set_target_properties(tyndall_runtime PROPERTIES EXPORT_NAME runtime)

install(TARGETS permgen permgen_tables permgen_manifest EXPORT permgenTargets)
# Two sets, so that the component plan alone does not need Vulkan.
install(TARGETS tyndall_plan EXPORT tyndallPlanTargets)
install(TARGETS tyndall_runtime EXPORT tyndallRuntimeTargets)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/permgen/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/plan/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/runtime/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
# The runtime's effects, for programs that give their own builds of them to a DeviceContext.
foreach(shader IN ITEMS slices.fx composite.fx shadow_map.fx shadow.fxh)
  install(FILES "${PROJECT_SOURCE_DIR}/shaders/${shader}" DESTINATION "${CMAKE_INSTALL_DATADIR}/tyndall/shaders")
endforeach()
if(TARGET tyndall)
  install(TARGETS tyndall)
endif()
if(TARGET permgen_rig)
  set_target_properties(permgen_rig PROPERTIES EXPORT_NAME rig)
  install(TARGETS permgen_rig EXPORT permgenTargets)
endif()

set(permgen_exports permgenTargets)
set(tyndall_exports tyndallPlanTargets tyndallRuntimeTargets)
foreach(package IN ITEMS permgen tyndall)
  set(destination "${CMAKE_INSTALL_LIBDIR}/cmake/${package}")
  foreach(set IN LISTS ${package}_exports)
    install(EXPORT ${set} NAMESPACE ${package}:: DESTINATION "${destination}")
  endforeach()
  configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/${package}Config.cmake.in"
                                "${PROJECT_BINARY_DIR}/cmake/${package}Config.cmake"
                                INSTALL_DESTINATION "${destination}")
  # Before 1.0 every minor version may break compatibility.
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/cmake/${package}ConfigVersion.cmake"
                                   COMPATIBILITY SameMinorVersion)
  install(FILES "${PROJECT_BINARY_DIR}/cmake/${package}Config.cmake"
                "${PROJECT_BINARY_DIR}/cmake/${package}ConfigVersion.cmake"
          DESTINATION "${destination}")
endforeach()
install(FILES "${PROJECT_SOURCE_DIR}/cmake/PermgenEffect.cmake" "${PROJECT_SOURCE_DIR}/cmake/PermgenRig.cmake"
              "${PROJECT_SOURCE_DIR}/cmake/PermgenRigTests.cmake"
        DESTINATION "${CMAKE_INSTALL_LIBDIR}/cmake/permgen")
