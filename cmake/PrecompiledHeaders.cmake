# Precompiled headers only make a clean build faster: no source needs them, and they are not installed. There are two
# sets, because GCC accepts a precompiled header only with the same flags: libraries and programs use the build type's
# optimization, tests -O1 (see tests/CMakeLists.txt).
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
set(tyndall_precompiled
    <algorithm> <array> <cmath> <cstdint> <filesystem> <fstream> <functional> <map> <memory> <optional> <set> <span>
    <sstream> <string> <string_view> <unordered_map> <vector> <glm/glm.hpp> <nlohmann/json.hpp>)

# tyndall_precompile(<name> [HEADERS <header>...] [OPTIONS <option>...]): makes the set.
function(tyndall_precompile name)
  cmake_parse_arguments(PARSE_ARGV 1 set "" "" "HEADERS;OPTIONS")
  file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp" CONTENT "// Only its precompiled header is used.\n")
  add_library(${name} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  target_compile_options(${name} PRIVATE ${set_OPTIONS})
  target_link_libraries(${name} PRIVATE glm::glm nlohmann_json::nlohmann_json tyndall_compiler_settings)
  target_precompile_headers(${name} PRIVATE ${tyndall_precompiled} ${set_HEADERS})
endfunction()

# tyndall_use_precompiled(<name> <target>...): targets that do not exist in this configuration are skipped.
function(tyndall_use_precompiled name)
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      target_precompile_headers(${target} REUSE_FROM ${name})
    endif()
  endforeach()
endfunction()
