# Headers, libraries, the program, a package that find_package(Cocoon) finds, and the documentation
# with its examples, in the folders that its links expect.
include(CMakePackageConfigHelpers)

set(layers geom delaunay cocone update io)
foreach(layer ${layers})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${layer}/
          DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/cocoon/${layer}
          FILES_MATCHING PATTERN "*.h")
  install(TARGETS cocoon_${layer} EXPORT CocoonTargets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
endforeach()
install(TARGETS cocoon_flags EXPORT CocoonTargets)
install(TARGETS cocoon_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(EXPORT CocoonTargets NAMESPACE Cocoon::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Cocoon)

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/CocoonConfig.cmake.in
  ${PROJECT_BINARY_DIR}/CocoonConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Cocoon)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/CocoonConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/CocoonConfig.cmake
              ${PROJECT_BINARY_DIR}/CocoonConfigVersion.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Cocoon)

install(FILES LICENSE README.md CHANGELOG.md CITATION.cff CONTRIBUTING.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY bench ref DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md"
        PATTERN "rivals" EXCLUDE)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR}
        FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN "*.png" PATTERN "examples/*")
