// SPDX-License-Identifier: BSD-3-Clause
#include "robots/mesh_loader.h"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/input_error.h"
#include "robots/robot_model.h"
#include "robots/temporary_folder.h"

// Promises: meshes of the usual formats load with the right size wherever they lie, and everything that keeps
// one from loading is an error that names it.

namespace b4p {
namespace {

using testing::HasSubstr;

// A tetrahedron with legs of 1, 2 and 3 along the axes.
const float kCorners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
const int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

std::string asciiStl() {
  std::ostringstream text;
  text << "solid t\n";
  for (const auto& face : kFaces) {
    text << "facet normal 0 0 0\nouter loop\n";
    for (const int i : face)
      text << "vertex " << kCorners[i][0] << ' ' << kCorners[i][1] << ' ' << kCorners[i][2] << '\n';
    text << "endloop\nendfacet\n";
  }
  return text.str() + "endsolid t\n";
}

void append(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}

std::string binaryStl() {
  std::string bytes(80, ' ');
  const std::uint32_t count = 4;
  append(bytes, &count, sizeof count);
  for (const auto& face : kFaces) {
    const float normal[3] = {0, 0, 0};
    append(bytes, normal, sizeof normal);
    for (const int i : face) append(bytes, kCorners[i], sizeof kCorners[i]);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string obj() {
  std::ostringstream text;
  for (const auto& c : kCorners) text << "v " << c[0] << ' ' << c[1] << ' ' << c[2] << '\n';
  for (const auto& face : kFaces)
    text << "f " << face[0] + 1 << ' ' << face[1] + 1 << ' ' << face[2] + 1 << '\n';
  return text.str();
}

/// In centimetres, z up.
std::string dae() {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 100 0 0 0 200 0 0 0 300</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

std::string urdfWithMesh(const std::string& attributes) {
  return "<robot name=\"r\"><link name=\"a\"><collision><geometry><mesh " + attributes +
         "/></geometry></collision></link></robot>";
}

/// The only shape's vertex sums: the corner values survive in them, each once.
Eigen::Vector3d extent(const RobotModel& model) {
  const auto& mesh = std::get<std::shared_ptr<const ConvexMesh>>(model.links.at(0).shapes.at(0).shape);
  EXPECT_EQ(mesh->vertices.size(), 4u);
  EXPECT_EQ(mesh->triangles.size(), 4u);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& vertex : mesh->vertices) sum += vertex;
  return sum;
}

struct Format {
  const char* extension;
  std::string (*content)();
};

class MeshFormat : public testing::TestWithParam<Format> {};

TEST_P(MeshFormat, LoadsWithScale) {
  const TemporaryFolder folder;
  const std::string name = std::string("meshes/part.") + GetParam().extension;
  folder.write(name, GetParam().content());
  const auto plain = loadUrdf(folder.write("plain.urdf", urdfWithMesh("filename=\"" + name + "\"")));
  EXPECT_TRUE(extent(plain).isApprox(Eigen::Vector3d(1, 2, 3), 1e-6)) << extent(plain).transpose();
  const auto scaled =
      loadUrdf(folder.write("scaled.urdf", urdfWithMesh("filename=\"" + name + "\" scale=\"0.001 0.1 -2\"")));
  EXPECT_TRUE(extent(scaled).isApprox(Eigen::Vector3d(0.001, 0.2, -6), 1e-6)) << extent(scaled).transpose();
}

INSTANTIATE_TEST_SUITE_P(All, MeshFormat,
                         testing::Values(Format{"stl", asciiStl}, Format{"STL", binaryStl},
                                         Format{"obj", obj}, Format{"dae", dae}),
                         [](const auto& instance) {
                           return std::string(instance.param.extension) + "_" +
                                  std::to_string(instance.index);
                         });

class MeshPlace : public testing::Test {
 protected:
  void SetUp() override {
    if (const char* value = std::getenv("ROS_PACKAGE_PATH")) before_ = value;
    unsetenv("ROS_PACKAGE_PATH");
  }
  void TearDown() override {
    if (before_)
      setenv("ROS_PACKAGE_PATH", before_->c_str(), 1);
    else
      unsetenv("ROS_PACKAGE_PATH");
  }

  bool loads(const std::string& urdf, const std::string& address) const {
    const auto model = loadUrdf(folder_.write(urdf, urdfWithMesh("filename=\"" + address + "\"")));
    return extent(model).isApprox(Eigen::Vector3d(1, 2, 3));
  }

  TemporaryFolder folder_;
  std::optional<std::string> before_;
};

TEST_F(MeshPlace, RelativeToTheUrdf) {
  folder_.write("meshes/a.stl", asciiStl());
  EXPECT_TRUE(loads("urdf/r.urdf", "../meshes/a.stl"));
}

TEST_F(MeshPlace, Absolute) {
  const std::string file = folder_.write("elsewhere/a.stl", asciiStl());
  EXPECT_TRUE(loads("urdf/r.urdf", file));
  EXPECT_TRUE(loads("urdf/r.urdf", "file://" + file));
}

TEST_F(MeshPlace, InAPackageAboveTheUrdf) {
  folder_.write("arm_description/meshes/a.stl", asciiStl());
  EXPECT_TRUE(loads("arm_description/urdf/deep/r.urdf", "package://arm_description/meshes/a.stl"));
}

TEST_F(MeshPlace, InAPackageBesideThatOfTheUrdf) {
  folder_.write("meshes_only/a.stl", asciiStl());
  EXPECT_TRUE(loads("arm_description/urdf/r.urdf", "package://meshes_only/a.stl"));
}

TEST_F(MeshPlace, InAPackageOnTheRosPath) {
  const TemporaryFolder elsewhere;
  elsewhere.write("src/far_away/a.stl", asciiStl());
  setenv("ROS_PACKAGE_PATH", ("/nowhere:" + elsewhere.path() + "/src").c_str(), 1);
  EXPECT_TRUE(loads("r.urdf", "package://far_away/a.stl"));
  setenv("ROS_PACKAGE_PATH", (elsewhere.path() + "/src/far_away/").c_str(), 1);
  EXPECT_TRUE(loads("r.urdf", "package://far_away/a.stl"));
}

TEST_F(MeshPlace, RelativeToAUrdfNamedWithoutAFolder) {
  folder_.write("a.stl", asciiStl());
  folder_.write("r.urdf", urdfWithMesh("filename=\"a.stl\""));
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path());
  EXPECT_NO_THROW(loadUrdf("r.urdf"));
  std::filesystem::current_path(before);
}

class BadMesh : public MeshPlace {
 protected:
  std::string problem(const std::string& address, const std::string& more = "") const {
    try {
      loadUrdf(folder_.write("r.urdf", urdfWithMesh("filename=\"" + address + "\" " + more)));
    } catch (const InputError& error) {
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      EXPECT_THAT(error.what(), HasSubstr("r.urdf: link 'a': "));
      return error.what();
    }
    return "";
  }
};

TEST_F(BadMesh, Missing) {
  EXPECT_THAT(problem("nowhere.stl"), HasSubstr("mesh 'nowhere.stl': no such file"));
  EXPECT_THAT(problem("package://unknown/a.stl"), HasSubstr("no folder 'unknown'"));
  EXPECT_THAT(problem("package://"), HasSubstr("names no package"));
  EXPECT_THAT(problem(""), HasSubstr("has no filename"));
}

TEST_F(BadMesh, EmptyOrGarbage) {
  folder_.write("empty.stl", "");
  folder_.write("garbage.obj", "this is no mesh");
  folder_.write("half.STL", binaryStl().substr(0, 150));
  folder_.write("unknown.xyz", "0 0 0");
  for (const char* name : {"empty.stl", "garbage.obj", "half.STL", "unknown.xyz"})
    EXPECT_THAT(problem(name), HasSubstr(std::string("mesh '") + name + "': holds no mesh")) << name;
}

TEST_F(BadMesh, Flat) {
  folder_.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 3 4\n");
  EXPECT_THAT(problem("flat.obj"), HasSubstr("mesh 'flat.obj': the points span no volume"));
}

TEST_F(BadMesh, NonFiniteVertex) {
  std::string bytes = binaryStl();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(&bytes[84 + 12], &nan, sizeof nan);
  folder_.write("nan.stl", bytes);
  EXPECT_THAT(problem("nan.stl"), HasSubstr("mesh 'nan.stl': a point is not finite"));
}

TEST_F(BadMesh, Scale) {
  folder_.write("a.stl", asciiStl());
  for (const char* scale : {"0 1 1", "nan 1 1", "1 inf 1", "1 1", "1", "x y z", "1e999 1 1"})
    EXPECT_THAT(problem("a.stl", std::string("scale=\"") + scale + "\""),
                HasSubstr(std::string("mesh scale '") + scale + "'"));
  EXPECT_THAT(problem("a.stl", "scale=\"1e200 1e200 1e200\""), HasSubstr("link 'a'"));
}

}  // namespace
}  // namespace b4p
