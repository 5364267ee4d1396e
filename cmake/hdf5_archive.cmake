# Debian's shared library of HDF5 brings curl and some thirty libraries with it, for files on the web.
# They cost every start of a program 20 ms. Of the archive the linker takes what is used (docs/adr/0028-*.md).
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5>=1.10)
find_library(HDF5_ARCHIVE_FILE NAMES libhdf5.a libhdf5_serial.a HINTS ${HDF5_LIBRARY_DIRS} NO_CACHE)
find_library(SZIP_FILE NAMES sz NO_CACHE)

# link_hdf5_archive(PROGRAM): the program gets HDF5 out of its archive, and not the shared library, where there
# is an archive.
function(link_hdf5_archive program)
  if(HDF5_ARCHIVE_FILE AND SZIP_FILE)
    set_target_properties(${program} PROPERTIES HDF5_ARCHIVE ON)
  endif()
endfunction()

# link_hdf5(LIBRARY): what a static library that calls HDF5 asks of the program that is linked. The archive comes after
# the library on the linker's line, or it would be searched before anything of it is missed.
function(link_hdf5 library)
  set(has_archive $<BOOL:$<TARGET_PROPERTY:HDF5_ARCHIVE>>)
  target_include_directories(${library} PRIVATE ${HDF5_INCLUDE_DIRS})
  target_link_libraries(${library} PRIVATE $<$<NOT:${has_archive}>:PkgConfig::HDF5>)
  if(HDF5_ARCHIVE_FILE AND SZIP_FILE)
    foreach(part ${HDF5_ARCHIVE_FILE} ${SZIP_FILE} ZLIB::ZLIB ${CMAKE_DL_LIBS} m)
      target_link_libraries(${library} PRIVATE $<BUILD_INTERFACE:$<${has_archive}:${part}>>)
    endforeach()
  endif()
endfunction()
