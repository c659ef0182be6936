# cmake -D CMAKE_UNITY_BUILD=ON compiles several files together as one, which halves the time of a clean build; cmake/test
# and cmake/demo do so in a new build folder. Without it every file is compiled by itself, which is better where one file
# changes often.
#
# Names in an unnamed namespace must then differ among files that are compiled together. Files of one folder are; a
# target without folders is cut into batches, whose borders move as files come and go, so all its files count.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 12)

# tyndall_unity_by_folder(<target>...): a unit for each folder of the target's sources.
function(tyndall_unity_by_folder)
  foreach(target IN LISTS ARGN)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
    get_target_property(home ${target} SOURCE_DIR)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    foreach(source IN LISTS sources)
      cmake_path(GET source PARENT_PATH folder)
      string(MAKE_C_IDENTIFIER "in_${folder}" group)
      cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${home}" NORMALIZE)
      set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP ${group})
    endforeach()
  endforeach()
endfunction()
