# Debian's shared library of HDF5 brings curl and some thirty libraries with it, for files on the web.
# They cost every start of a program 20 ms. Of the archive the linker takes what is used (docs/adr/0028-*.md).
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5>=1.10)
find_library(HDF5_ARCHIVE_FILE NAMES libhdf5.a libhdf5_serial.a HINTS ${HDF5_LIBRARY_DIRS} NO_CACHE)
find_library(SZIP_FILE NAMES sz NO_CACHE)

# link_hdf5_archive(PROGRAM): the program gets HDF5 out of its archive, and not the shared library, where there
# is an archive.
function(link_hdf5_archive program)
  if(NOT HDF5_ARCHIVE_FILE OR NOT SZIP_FILE)
    return()
  endif()
  set_target_properties(${program} PROPERTIES HDF5_ARCHIVE ON)  # formats asks for it
  target_link_libraries(${program} PRIVATE ${HDF5_ARCHIVE_FILE} ${SZIP_FILE} ZLIB::ZLIB ${CMAKE_DL_LIBS} m)
endfunction()
