# SPDX-License-Identifier: BSD-3-Clause
# A Debian package by CPack (scripts/deb.sh, `make deb`), with the files that Debian's policy asks for.
# The same sources give the same bytes wherever they lie: no path of this machine stays in a program, and every time in
# the package is SOURCE_DATE_EPOCH.

set(LUXPIPE_MAINTAINER "The luxpipe authors <luxpipe@example.org>" CACHE STRING "who answers for the package")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME luxpipe)
set(CPACK_PACKAGE_VERSION ${LUXPIPE_VERSION_TEXT})
set(CPACK_PACKAGE_CONTACT ${LUXPIPE_MAINTAINER})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "visual comfort of a daylit room by path tracing")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Seven programs, most of them on one pipe.  ptrace renders a RADIANCE
scene by path tracing, frame after frame, on the processor or by OpenCL;
ptaccum sums the frames to a picture that gets better with each; vcmetrics
measures glare, illuminance, luminance and contrast in it until they have
settled; vcregion draws the regions that it measures; vcyear sums up the
hours of a year; vcview shows all this in a browser, where luxpipe-live lets
the scene be edited.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS pocl-opencl-icd)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)

if(LUXPIPE_DEB OR SKBUILD OR WIN32)  # set by scripts/deb.sh, or by scripts/wheel.sh through scikit-build-core
  add_compile_options(-ffile-prefix-map=${PROJECT_SOURCE_DIR}=. -ffile-prefix-map=${CMAKE_BINARY_DIR}=build)
endif()
if(LUXPIPE_DEB)
  string(TIMESTAMP day "%a, %d %b %Y %H:%M:%S +0000" UTC)  # knows SOURCE_DATE_EPOCH
  set(head "luxpipe (${LUXPIPE_VERSION_TEXT}) unstable; urgency=medium")
  file(WRITE ${CMAKE_BINARY_DIR}/doc/changelog
    "${head}\n\n  * See CHANGELOG.md.\n\n -- ${LUXPIPE_MAINTAINER}  ${day}\n")
  file(COPY ${PROJECT_SOURCE_DIR}/man DESTINATION ${CMAKE_BINARY_DIR})
  file(GLOB pages ${CMAKE_BINARY_DIR}/man/*.[157])
  execute_process(COMMAND gzip -9nf ${pages} ${CMAKE_BINARY_DIR}/doc/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES LICENSE DESTINATION share/doc/luxpipe RENAME copyright)
  install(DIRECTORY examples DESTINATION share/doc/luxpipe
    PATTERN "office.hdr" EXCLUDE PATTERN "day_*.hdr" EXCLUDE PATTERN "*.exr" EXCLUDE PATTERN "*.png" EXCLUDE)
  install(FILES CHANGELOG.md ${CMAKE_BINARY_DIR}/doc/changelog.gz DESTINATION share/doc/luxpipe)
endif()
