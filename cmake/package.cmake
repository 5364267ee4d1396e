# Debian packages (`./bootstrap deb`): pentimento, libpentimento-dev and python3-pentimento.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pentimento)
set(CPACK_PACKAGE_VENDOR pentimento)
set(CPACK_PACKAGE_CONTACT "The pentimento maintainers <pentimento@users.noreply.github.com>")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_COMPONENTS_ALL command development)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME pentimento)
set(CPACK_DEBIAN_COMMAND_PACKAGE_SECTION graphics)
set(CPACK_COMPONENT_COMMAND_DESCRIPTION "replays recorded oil-painting sessions
A log of touches, gravity and sliders becomes the oil painting that it was, at any size:
a picture (PNG, EXR), a film, or the state of the paint (HDF5).")
# Mesa shades the picture. It is loaded when the first picture is made: states need none.
set(CPACK_DEBIAN_COMMAND_PACKAGE_RECOMMENDS "libosmesa6 | libegl1, libgl1-mesa-dri")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libpentimento-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
# What find_package(pentimento) looks for in its turn.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libfmt-dev, libsimdjson-dev, libpugixml-dev, \
libzip-dev, libprotobuf-dev, libzstd-dev, zlib1g-dev, libdeflate-dev, libssl-dev, libxxhash-dev, libhdf5-dev, libpng-dev, \
libjpeg-dev, libtiff-dev, libopenexr-dev, liblcms2-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "libraries of pentimento
The oil-paint simulation, its file formats and the replay of logs, as static libraries for C++20,
with headers and what find_package(pentimento) reads.")

if(TARGET pentimento_engine)
  list(APPEND CPACK_COMPONENTS_ALL python)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-pentimento)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  # The engine is built for the Python that built it.
  set(Python_EXECUTABLE ${PENTIMENTO_PYTHON})
  find_package(Python COMPONENTS Interpreter REQUIRED)
  set(python_minor "${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}")
  math(EXPR python_next "${Python_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= ${python_minor}), python3 (<< ${Python_VERSION_MAJOR}.${python_next}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "pentimento (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-h5py, python3-distributed")
  set(CPACK_COMPONENT_PYTHON_DESCRIPTION "oil paint for Python
Writes logs of painting sessions, reads states as numpy arrays, and paints in process.")
endif()

# Each package says under which terms it may be used.
foreach(part command:pentimento development:libpentimento-dev python:python3-pentimento)
  string(REPLACE ":" ";" part ${part})
  list(GET part 0 component)
  list(GET part 1 package)
  if(component IN_LIST CPACK_COMPONENTS_ALL)
    install(FILES ${CMAKE_SOURCE_DIR}/LICENSE DESTINATION share/doc/${package} RENAME copyright
      COMPONENT ${component} EXCLUDE_FROM_ALL)
  endif()
endforeach()
include(CPack)
