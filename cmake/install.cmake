# The libraries as others use them: find_package(pentimento), then pentimento::core, ::formats and
# ::replay (docs/architecture.md, as a library).
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pentimento)

# A folder of its own under include: `#include "core/simulation/simulation.h"` is the same in here and outside.
set(header_dir ${CMAKE_INSTALL_INCLUDEDIR}/pentimento)
foreach(library core formats replay)
  add_library(pentimento::${library} ALIAS ${library})
  set_target_properties(${library} PROPERTIES OUTPUT_NAME pentimento-${library})
  target_include_directories(${library} INTERFACE $<INSTALL_INTERFACE:${header_dir}>)
  target_compile_features(${library} INTERFACE cxx_std_20)
endforeach()
# Of our options consumers get one. Functions in our headers may be compiled in the consumer's
# sources too, and the linker keeps one copy for all: a fused multiply-add there would change states.
target_compile_options(core INTERFACE
  $<INSTALL_INTERFACE:$<$<COMPILE_LANGUAGE:CXX>:-ffp-contract=off>>)

install(TARGETS core formats replay EXPORT pentimentoTargets 
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT pentimentoTargets NAMESPACE pentimento:: DESTINATION ${package_dir} COMPONENT development)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/pentimentoConfig.cmake.in
  ${CMAKE_BINARY_DIR}/pentimentoConfig.cmake INSTALL_DESTINATION ${package_dir})
# Before 1.0 a minor version may break what was; a consumer names the one it was written for.
write_basic_package_version_file(${CMAKE_BINARY_DIR}/pentimentoConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/pentimentoConfig.cmake ${CMAKE_BINARY_DIR}/pentimentoConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT development)

# Headers that need more than the standard library and Eigen stay here: those of OpenGL, HDF5 and
# OpenEXR, and those which include them. tests/install checks that no other header needs more.
set(private_headers
  functions objects library context gl_limits lamp_uniforms picture_job shade_program strip_writer
  chunked dump_source global_heap input_driver packed_chunks handle lighting_parts detail_checkpoint output_driver read_canvas read_dump read_small sleep write_canvas write_small
  chromaticities stream typed_attribute)
list(JOIN private_headers | private_names)
install(DIRECTORY core formats replay DESTINATION ${header_dir} COMPONENT development FILES_MATCHING PATTERN "*.h"
  REGEX "/(shading|gl|hdf5|exr)/(${private_names})\\.h$" EXCLUDE
  REGEX "/(shaders|data|cmake|page)$" EXCLUDE)
