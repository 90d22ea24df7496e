# The libraries b4p stands on, each as one target. Included by the build and by the installed package.
include(CMakeFindDependencyMacro)

find_package(Eigen3 REQUIRED NO_MODULE)
find_package(ompl REQUIRED) # no version: OMPL's version file refuses other majors
find_package(Boost REQUIRED COMPONENTS serialization filesystem system) # libompl-dev 1.5 omits them
find_package(fcl REQUIRED)
find_package(hwy REQUIRED)
find_package(orocos_kdl REQUIRED)
find_package(urdfdom REQUIRED)
find_package(assimp REQUIRED)
find_package(Qhull REQUIRED)
find_package(tinyxml2 REQUIRED)
find_package(Threads REQUIRED)

# OMPL has a target of its own only from 1.7 on.
if(NOT TARGET b4p_ompl)
  add_library(b4p_ompl INTERFACE IMPORTED)
  if(TARGET ompl::ompl)
    target_link_libraries(b4p_ompl INTERFACE ompl::ompl)
  else()
    target_include_directories(b4p_ompl SYSTEM INTERFACE ${OMPL_INCLUDE_DIRS})
    target_link_libraries(b4p_ompl INTERFACE ${OMPL_LIBRARIES} Boost::serialization Boost::filesystem
                                             Boost::system Eigen3::Eigen)
  endif()
endif()

if(NOT TARGET b4p_kdl)
  add_library(b4p_kdl INTERFACE IMPORTED)
  target_include_directories(b4p_kdl SYSTEM INTERFACE ${orocos_kdl_INCLUDE_DIRS})
  target_link_libraries(b4p_kdl INTERFACE ${orocos_kdl_LIBRARIES} Eigen3::Eigen)
endif()
