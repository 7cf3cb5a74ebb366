# Version, commit and flags of the build, in the header stresslet/io/build.hpp that only io/provenance.cpp includes.
#
# Included by the top CMakeLists.txt it defines `stresslet_provenance(<target>)`. Run as a script at every build
# (cmake -P) it writes the header, touching it only when its content changes: a new commit recompiles one file.
if(CMAKE_SCRIPT_MODE_FILE)
  execute_process(COMMAND git describe --always --abbrev=12 --exclude=* --dirty=+changes WORKING_DIRECTORY "${SOURCE_DIR}"
                  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT commit)
    set(commit "unknown")
  endif()
  file(READ "${TEMPLATE}" header)
  string(REPLACE "<commit>" "${commit}" header "${header}")
  set(present "")
  if(EXISTS "${HEADER}")
    file(READ "${HEADER}" present)
  endif()
  if(NOT header STREQUAL present)
    file(WRITE "${HEADER}" "${header}")
  endif()
  return()
endif()

set(STRESSLET_PROVENANCE_SCRIPT "${CMAKE_CURRENT_LIST_FILE}")

function(stresslet_provenance target)
  set(folder "${PROJECT_BINARY_DIR}/provenance")
  string(TOUPPER "${CMAKE_BUILD_TYPE}" type)
  get_target_property(options stresslet_options INTERFACE_COMPILE_OPTIONS)
  string(REPLACE ";" " " flags "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${type}} ${options}")
  string(STRIP "${flags}" flags)
  file(CONFIGURE OUTPUT "${folder}/template.hpp" @ONLY CONTENT [[
#pragma once
namespace stresslet::build {
inline constexpr const char* version = "@PROJECT_VERSION@";
inline constexpr const char* commit = "<commit>";
inline constexpr const char* compiler = "@CMAKE_CXX_COMPILER_ID@ @CMAKE_CXX_COMPILER_VERSION@";
inline constexpr const char* type = "@CMAKE_BUILD_TYPE@";
inline constexpr const char* flags = "@flags@";
}  // namespace stresslet::build
]])
  add_custom_target(stresslet_commit BYPRODUCTS "${folder}/stresslet/io/build.hpp" VERBATIM
                    COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR} -D TEMPLATE=${folder}/template.hpp
                            -D HEADER=${folder}/stresslet/io/build.hpp -P ${STRESSLET_PROVENANCE_SCRIPT}
                    COMMENT "Noting the commit of this build")
  add_dependencies(${target} stresslet_commit)
  target_include_directories(${target} PRIVATE "${folder}")
endfunction()
