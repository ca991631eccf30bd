# SPDX-License-Identifier: MIT
# cmake --install BUILD --prefix PREFIX. Programs find their files relative to their own path, so that a prefix may be moved;
# systemd's units contain the prefix.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The client library: headers keep their place in the tree, below one folder.
set(headers ${CMAKE_INSTALL_INCLUDEDIR}/hedgehog)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Hedgehog)
foreach(layer base model protocol client asio)
  set_target_properties(hedgehog_${layer} PROPERTIES EXPORT_NAME ${layer})
  list(APPEND client_libraries hedgehog_${layer})
endforeach()
install(TARGETS ${client_libraries} EXPORT HedgehogTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        INCLUDES DESTINATION ${headers})
install(DIRECTORY base model protocol DESTINATION ${headers} FILES_MATCHING PATTERN *.h
        PATTERN keys EXCLUDE PATTERN identification EXCLUDE PATTERN schema EXCLUDE)
install(DIRECTORY clients/lib DESTINATION ${headers}/clients FILES_MATCHING PATTERN *.h)
install(EXPORT HedgehogTargets NAMESPACE Hedgehog:: DESTINATION ${package})
configure_package_config_file(cmake/HedgehogConfig.cmake.in HedgehogConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(HedgehogConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/HedgehogConfig.cmake ${PROJECT_BINARY_DIR}/HedgehogConfigVersion.cmake
        DESTINATION ${package})
# The prefix in a .pc file is relative to its location, as in HedgehogConfig.cmake.
file(RELATIVE_PATH HEDGEHOG_PREFIX_FROM_PC /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(cmake/hedgehog-client.pc.in hedgehog-client.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/hedgehog-client.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

if(NOT HEDGEHOG_PROGRAMS)
  return()
endif()

set(data ${CMAKE_INSTALL_DATADIR}/hedgehog)
install(TARGETS hedgehogd hedgehog-simboard hedgehogctl hedgehog-gamepad hedgehog-mqtt hedgehog-orientation hedgehog-study hedgehog-design hedgehog-racer
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES config/hedgehogd.json DESTINATION ${data})
install(DIRECTORY config/devices.d config/patterns config/study DESTINATION ${data} FILES_MATCHING PATTERN *.json)
install(DIRECTORY config/monitoring DESTINATION ${data} PATTERN README.md EXCLUDE PATTERN *.test.yml EXCLUDE)
install(FILES protocol/schema/openrpc.json protocol/schema/messages.schema.json DESTINATION ${data}/schema)
# Pages that npm has bundled into the build, if it has: make dashboard, make racer-page.
install(DIRECTORY ${PROJECT_BINARY_DIR}/share/hedgehog/ DESTINATION ${data} OPTIONAL)

# Man pages and completions, which the programs write themselves (cli/).
set(share ${PROJECT_BINARY_DIR}/share)
install(DIRECTORY ${share}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR})
install(DIRECTORY ${share}/bash-completion ${share}/zsh ${share}/fish DESTINATION ${CMAKE_INSTALL_DATADIR})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(CODE "
  set(HEDGEHOG_SOURCE \"${PROJECT_SOURCE_DIR}\")
  set(HEDGEHOG_DOCUMENTS \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DOCDIR}\")
  include(\"${PROJECT_SOURCE_DIR}/cmake/documents.cmake\")")

# systemd and udev read files below lib, not in the architecture's own folder.
install(FILES systemd/60-hedgehog.rules systemd/61-hedgehog-gamepad.rules DESTINATION lib/udev/rules.d)
install(FILES systemd/hedgehog.sysusers DESTINATION lib/sysusers.d RENAME hedgehog.conf)
install(FILES systemd/hedgehog.tmpfiles DESTINATION lib/tmpfiles.d RENAME hedgehog.conf)
install(FILES systemd/hedgehogd.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo)
install(FILES systemd/hedgehog-gamepad.sysusers DESTINATION lib/sysusers.d RENAME hedgehog-gamepad.conf)
# A unit contains the absolute path of the program, which is known once the prefix is.
install(CODE "
  foreach(unit hedgehogd.service hedgehogd@.service hedgehog-gamepad.service hedgehog-mqtt.service hedgehog-mqtt@.service)
    file(READ \"${PROJECT_SOURCE_DIR}/systemd/\${unit}\" text)
    string(REPLACE /usr/bin/hedgehog \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}/hedgehog\" text \"\${text}\")
    set(installed \"\${CMAKE_INSTALL_PREFIX}/lib/systemd/system/\${unit}\")
    message(STATUS \"Installing: \$ENV{DESTDIR}\${installed}\")
    file(WRITE \"\$ENV{DESTDIR}\${installed}\" \"\${text}\")
    list(APPEND CMAKE_INSTALL_MANIFEST_FILES \"\${installed}\")
  endforeach()")
