# One target per folder of src/, linked along the ladder.
add_library(frit_flags INTERFACE)
target_include_directories(frit_flags INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src> $<INSTALL_INTERFACE:include/frit>)
target_compile_features(frit_flags INTERFACE cxx_std_20)
# The same bits at every optimisation level need uncontracted arithmetic; never -ffast-math.
target_compile_options(frit_flags INTERFACE
  "$<BUILD_INTERFACE:-Wall;-Wextra;-Wconversion;-Wshadow;-Wpedantic;-Wnon-virtual-dtor;-Wno-sign-conversion>"
  -Wno-psabi -ffp-contract=off)
# x86-64-v3 and not native: g++ 12 warns wrongly inside its AVX-512 headers, the solver gains nothing from
# it, and one instruction set gives the same bits on all machines that have it. Programs that link the installed
# libraries get it too: Eigen's alignment depends on it.
set(frit_march "${FRIT_MARCH}")
if(frit_march STREQUAL "AUTO")
  set(frit_march "")
  if(EXISTS /proc/cpuinfo)
    file(STRINGS /proc/cpuinfo frit_cpu REGEX "^flags.* avx2 .*" LIMIT_COUNT 1)
    if(frit_cpu MATCHES " fma " AND frit_cpu MATCHES " bmi2 ")
      set(frit_march x86-64-v3)
    endif()
  endif()
endif()
# For files where g++ 12 contracts all the same: its vectoriser of straight code makes vfmaddsub of products and sums.
# Without it debug, release and clang have the same bits. The test Objects.uncontracted finds such files.
set(frit_uncontracted -fno-tree-slp-vectorize)
if(frit_march)
  target_compile_options(frit_flags INTERFACE -march=${frit_march})
endif()
if(FRIT_WERROR)
  target_compile_options(frit_flags INTERFACE $<BUILD_INTERFACE:-Werror>)
endif()
# The Python module is made of the same objects as the program; nobody replaces our functions when they load.
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
target_compile_options(frit_flags INTERFACE $<BUILD_INTERFACE:-fno-semantic-interposition>)
if(FRIT_CHECKS)
  target_compile_definitions(frit_flags INTERFACE FRIT_CHECKS=1 _GLIBCXX_ASSERTIONS)
else()
  target_compile_definitions(frit_flags INTERFACE EIGEN_NO_DEBUG)
endif()
if(FRIT_SANITIZE)
  target_compile_options(frit_flags INTERFACE -fsanitize=${FRIT_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(frit_flags INTERFACE -fsanitize=${FRIT_SANITIZE})
endif()

if(FRIT_COVERAGE)
  target_compile_options(frit_flags INTERFACE $<BUILD_INTERFACE:--coverage;-fprofile-update=atomic>)
  target_link_options(frit_flags INTERFACE --coverage)  # also of others' programs: the libraries need it
endif()

# frit_library(name SOURCES ... USES rung ... LIBRARIES external ...)
function(frit_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;LIBRARIES" ${ARGN})
  add_library(frit_${name} STATIC ${ARG_SOURCES})
  target_link_libraries(frit_${name} PUBLIC frit_flags)
  foreach(rung ${ARG_USES})
    target_link_libraries(frit_${name} PUBLIC frit_${rung})
  endforeach()
  foreach(library ${ARG_LIBRARIES})
    target_link_libraries(frit_${name} PUBLIC ${library})
  endforeach()
endfunction()
