# b4p_library(NAME SOURCES...): the library of one room, as target b4p_NAME and alias b4p::NAME. Headers are
# included as "NAME/header.h", in the build and after installation.
function(b4p_library name)
  add_library(b4p_${name} ${ARGN})
  add_library(b4p::${name} ALIAS b4p_${name})
  set_target_properties(b4p_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_compile_features(b4p_${name} PUBLIC cxx_std_17)
  target_include_directories(b4p_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/b4p>)
  b4p_warnings(b4p_${name})
endfunction()

function(b4p_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                                           $<$<BOOL:${B4P_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
