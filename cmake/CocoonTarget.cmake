# The rules that every target of the project follows, in one place.

# -ffp-contract=off: a fused multiply-add rounds once where the error bounds of the predicates
# count two roundings, and differs between machines.
add_library(cocoon_flags INTERFACE)
target_compile_features(cocoon_flags INTERFACE cxx_std_20)
target_compile_options(cocoon_flags INTERFACE -ffp-contract=off)
# Only a build with asserts calls the shared library of Highway (geom/lanes/vector_dispatch.h).
target_link_options(cocoon_flags INTERFACE LINKER:--as-needed)

add_library(cocoon_warnings INTERFACE)
target_compile_options(cocoon_warnings INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Werror)

if(COCOON_SANITIZE)
  target_compile_options(cocoon_flags INTERFACE
    -fsanitize=${COCOON_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(cocoon_flags INTERFACE -fsanitize=${COCOON_SANITIZE})
endif()

# cocoon_layer(name DEPENDS layers... [PRIVATE targets...]): the library of one folder. All .cpp
# files of the folder and its sub-folders belong to it. Headers are included from the project's root.
function(cocoon_layer name)
  cmake_parse_arguments(arg "" "" "DEPENDS;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp */*.cpp)
  add_library(cocoon_${name} STATIC ${sources})
  add_library(Cocoon::${name} ALIAS cocoon_${name})
  set_target_properties(cocoon_${name} PROPERTIES EXPORT_NAME ${name}
    POSITION_INDEPENDENT_CODE ON)
  target_include_directories(cocoon_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/cocoon>)
  target_link_libraries(cocoon_${name}
    PUBLIC cocoon_flags
    PRIVATE $<BUILD_INTERFACE:cocoon_warnings>)
  # A fuzzer that watches comparisons learns what a reader expects. Geometry expects nothing, and
  # watching its comparisons takes most of the time.
  if(COCOON_SANITIZE MATCHES "fuzzer" AND name MATCHES "^(geom|delaunay|cocone|update)$")
    target_compile_options(cocoon_${name} PRIVATE -O2 -fno-sanitize-coverage=trace-cmp)
  endif()
  foreach(layer ${arg_DEPENDS})
    target_link_libraries(cocoon_${name} PUBLIC cocoon_${layer})
  endforeach()
  target_link_libraries(cocoon_${name} PRIVATE ${arg_PRIVATE})
endfunction()
