# The parts of OpenCV that draw text and write videos, and read pictures for the tests: targets
# OpenCVParts::core, ::imgproc, ::videoio, and ::imgcodecs where it is installed.
# OpenCV's own package file comes only with its whole development set, ten times this size.
find_path(OpenCVParts_INCLUDE_DIR opencv2/videoio.hpp PATH_SUFFIXES opencv4)
set(opencv_parts_required OpenCVParts_INCLUDE_DIR)
foreach(part core imgproc videoio)
  find_library(OpenCVParts_${part}_LIBRARY opencv_${part})
  list(APPEND opencv_parts_required OpenCVParts_${part}_LIBRARY)
endforeach()
find_library(OpenCVParts_imgcodecs_LIBRARY opencv_imgcodecs)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenCVParts REQUIRED_VARS ${opencv_parts_required})
if(OpenCVParts_FOUND AND NOT TARGET OpenCVParts::core)
  foreach(part core imgproc imgcodecs videoio)
    if(OpenCVParts_${part}_LIBRARY)
      add_library(OpenCVParts::${part} UNKNOWN IMPORTED)
      set_target_properties(OpenCVParts::${part} PROPERTIES
        IMPORTED_LOCATION ${OpenCVParts_${part}_LIBRARY}
        INTERFACE_SYSTEM_INCLUDE_DIRECTORIES ${OpenCVParts_INCLUDE_DIR}
        INTERFACE_INCLUDE_DIRECTORIES ${OpenCVParts_INCLUDE_DIR})
    endif()
  endforeach()
endif()
mark_as_advanced(${opencv_parts_required} OpenCVParts_imgcodecs_LIBRARY)
