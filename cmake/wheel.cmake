# SPDX-License-Identifier: BSD-3-Clause
# What a Python wheel (pyproject.toml, scripts/wheel.sh) has beside the programs: the example scenes inside the package,
# manual pages where man looks for them (VENV/share/man), licences of the libraries that auditwheel puts in.
set(share ${SKBUILD_DATA_DIR}/share)
install(DIRECTORY examples/scenes/ DESTINATION examples PATTERN "*.exr" EXCLUDE PATTERN "*.png" EXCLUDE
  PATTERN "office.hdr" EXCLUDE PATTERN "day_*.hdr" EXCLUDE)
install(FILES examples/office.regions DESTINATION examples/office)
install(CODE "
  file(GLOB programs \${CMAKE_INSTALL_PREFIX}/bin/*)
  execute_process(COMMAND env LIBRARIES=${CMAKE_SYSROOT}${CMAKE_FIND_ROOT_PATH}
    bash ${PROJECT_SOURCE_DIR}/scripts/licences.sh \${CMAKE_INSTALL_PREFIX}/licences \${programs}
    COMMAND_ERROR_IS_FATAL ANY)")
