# The headers that most sources read, parsed once a target instead of once a file (-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON
# does without; every source includes what it uses all the same).
#
# ccache stores objects made from precompiled headers only if told so.
set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros
    ${CMAKE_CXX_COMPILER_LAUNCHER})
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
endif()

set(STRESSLET_COMMON_HEADERS <algorithm> <array> <atomic> <cmath> <experimental/simd> <filesystem> <functional> <map>
    <memory> <optional> <random> <span> <string> <thread> <vector> <Eigen/Dense> <fmt/format.h>)
