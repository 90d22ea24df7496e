// SPDX-License-Identifier: BSD-3-Clause
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/input_error.h"
#include "robots/robot_model.h"
#include "robots/temporary_folder.h"

// Promise: whatever is wrong with a URDF is one line that names the file, the element and the value. Most of
// these urdfdom accepts without a word.

namespace b4p {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string robot(const std::string& content) { return "<robot name=\"r\">" + content + "</robot>"; }

/// Links a and b, and joint j between them.
std::string twoLinks(const std::string& type, const std::string& joint_content) {
  return robot(R"(<link name="a"/><link name="b"/><joint name="j" type=")" + type +
               R"("><parent link="a"/><child link="b"/>)" + joint_content + "</joint>");
}

std::string limit(const std::string& attributes) {
  return "<limit velocity=\"1\" effort=\"1\" " + attributes + "/>";
}

const char* const kGoodLimit = R"(<limit lower="-1" upper="1" velocity="1" effort="1"/>)";

/// Link a with a collision.
std::string oneShape(const std::string& geometry, const std::string& origin = "") {
  return robot("<link name=\"a\"><collision>" + origin + "<geometry>" + geometry +
               "</geometry></collision></link>");
}

struct BadUrdf {
  std::string name;
  std::string text;
  std::string problem;  ///< what follows the file's name in the message
};

std::ostream& operator<<(std::ostream& stream, const BadUrdf& bad) { return stream << bad.name; }

std::string fixedJoint(const std::string& name, const std::string& parent, const std::string& child) {
  return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + parent + "\"/><child link=\"" +
         child + "\"/></joint>";
}

std::vector<BadUrdf> badTrees() {
  return {
      {"MalformedXml", "<robot name=\"r\"><link name=\"a\"></robot>", "line 1: malformed XML"},
      {"EmptyFile", "", "malformed XML"},
      {"CutInHalf", "<robot name=\"r\">\n<link name=\"a\"/>\n<joint na", "malformed XML"},
      {"OtherRoot", "<sdf/>", "the top element has to be <robot>, not <sdf>"},
      {"NoLinks", robot(""), "robot: has no links"},
      {"XacroElement", robot("<xacro:include filename=\"x\"/><link name=\"a\"/>"),
       "line 1: xacro that was not expanded: <xacro:include>"},
      {"XacroValue",
       robot(
           "\n<link name=\"a\"><collision><geometry><sphere radius=\"${r}\"/></geometry></collision></link>"),
       "line 2: xacro that was not expanded: radius=\"${r}\""},
      {"XacroCall", robot("<link name=\"$(arg prefix)a\"/>"),
       "xacro that was not expanded: name=\"$(arg prefix)a\""},
      {"LinkWithoutName", robot("<link/>"), "line 1: <link> has no name"},
      {"JointWithoutName", robot("<link name=\"a\"/><joint type=\"fixed\"/>"), "line 1: <joint> has no name"},
      {"DuplicateLink", robot("<link name=\"a\"/><link name=\"a\"/>"), "link 'a': is declared twice"},
      {"DuplicateJoint",
       robot(R"(<link name="a"/><link name="b"/><link name="c"/>)" + fixedJoint("j", "a", "b") +
             fixedJoint("j", "a", "c")),
       "joint 'j': is declared twice"},
      {"UnknownParent", robot("<link name=\"b\"/>" + fixedJoint("j", "ghost", "b")),
       "joint 'j': parent link 'ghost' does not exist"},
      {"UnknownChild", robot("<link name=\"a\"/>" + fixedJoint("j", "a", "ghost")),
       "joint 'j': child link 'ghost' does not exist"},
      {"NoParent", robot(R"(<link name="a"/><joint name="j" type="fixed"><child link="a"/></joint>)"),
       "joint 'j': has no parent link"},
      {"SeveralRoots", robot(R"(<link name="a"/><link name="b"/>)"), "link 'b': is a second root beside 'a'"},
      {"TwoParents",
       robot(R"(<link name="a"/><link name="b"/><link name="c"/>)" + fixedJoint("j", "a", "c") +
             fixedJoint("k", "b", "c")),
       "link 'c': is the child of two joints, 'j' and 'k'"},
      {"OwnParent", robot("<link name=\"a\"/>" + fixedJoint("j", "a", "a")), "link 'a': is its own ancestor"},
      {"Circle",
       robot(R"(<link name="root"/><link name="a"/><link name="b"/>)" + fixedJoint("j", "a", "b") +
             fixedJoint("k", "b", "a")),
       "link 'a': is its own ancestor"},
  };
}

std::vector<BadUrdf> badJoints() {
  return {
      {"FloatingJoint", twoLinks("floating", ""), "joint 'j': joint type 'floating' is not supported"},
      {"PlanarJoint", twoLinks("planar", ""), "joint 'j': joint type 'planar' is not supported"},
      {"UnknownJointType", twoLinks("hinge", ""), "joint 'j': joint type 'hinge' is not supported"},
      {"EmptyJointType", twoLinks("", ""), "joint 'j': <joint> has no type"},
      {"NoLimit", twoLinks("revolute", ""), "joint 'j': has no limit"},
      {"NoLimitPrismatic", twoLinks("prismatic", ""), "joint 'j': has no limit"},
      {"LimitWithoutEnds", twoLinks("revolute", limit("")), "joint 'j': limit has neither lower nor upper"},
      {"ReversedLimit", twoLinks("revolute", limit(R"(lower="1" upper="-1")")),
       "joint 'j': limit lower '1' has to be below upper '-1'"},
      {"EqualLimits", twoLinks("prismatic", limit(R"(lower="0.5" upper="0.5")")),
       "joint 'j': limit lower '0.5' has to be below upper '0.5'"},
      {"LowerAboveDefaultUpper", twoLinks("revolute", limit(R"(lower="1")")),
       "joint 'j': limit lower '1' has to be below upper '0'"},
      {"NanLimit", twoLinks("revolute", limit(R"(lower="nan" upper="1")")),
       "joint 'j': limit lower 'nan' has to be finite numbers"},
      {"InfiniteLimit", twoLinks("revolute", limit(R"(lower="-inf" upper="1")")),
       "joint 'j': limit lower '-inf'"},
      {"OverflowingLimit", twoLinks("revolute", limit(R"(lower="0" upper="1e999")")),
       "joint 'j': limit upper '1e999'"},
      {"WordLimit", twoLinks("revolute", limit(R"(lower="0" upper="1rad")")),
       "joint 'j': limit upper '1rad'"},
      {"NegativeVelocity", twoLinks("revolute", R"(<limit lower="0" upper="1" velocity="-1" effort="1"/>)"),
       "joint 'j': limit velocity '-1' must not be negative"},
      {"NoVelocity", twoLinks("revolute", R"(<limit lower="0" upper="1" effort="1"/>)"),
       "joint 'j': <limit> has no velocity"},
      {"NoEffort", twoLinks("revolute", R"(<limit lower="0" upper="1" velocity="1"/>)"),
       "joint 'j': <limit> has no effort"},
      {"ZeroAxis", twoLinks("revolute", std::string("<axis xyz=\"0 0 0\"/>") + kGoodLimit),
       "joint 'j': axis xyz '0 0 0' has no direction"},
      {"NanAxis", twoLinks("continuous", "<axis xyz=\"0 nan 1\"/>"),
       "joint 'j': axis xyz '0 nan 1' has to be finite numbers"},
      {"ShortAxis", twoLinks("continuous", "<axis xyz=\"0 1\"/>"),
       "joint 'j': axis xyz '0 1' has to be 3 number(s)"},
      {"NanOrigin", twoLinks("fixed", "<origin xyz=\"0 nan 0\"/>"), "joint 'j': origin xyz '0 nan 0'"},
      {"InfiniteOrigin", twoLinks("fixed", "<origin xyz=\"0 0 0\" rpy=\"inf 0 0\"/>"),
       "joint 'j': origin rpy 'inf 0 0'"},
      {"UnknownMimic", twoLinks("continuous", "<mimic joint=\"ghost\"/>"),
       "joint 'j': mimic joint 'ghost' does not exist"},
      {"MimicMultiplier", twoLinks("continuous", "<mimic joint=\"j\" multiplier=\"-1\"/>"),
       "joint 'j': mimic multiplier '-1' is not supported"},
      {"MimicOffset", twoLinks("continuous", "<mimic joint=\"j\" offset=\"0.1\"/>"),
       "joint 'j': mimic offset '0.1' is not supported"},
  };
}

std::vector<BadUrdf> badShapes() {
  return {
      {"NanBox", oneShape("<box size=\"0.1 nan 0.1\"/>"),
       "link 'a': box size '0.1 nan 0.1' has to be finite numbers"},
      {"NegativeBox", oneShape("<box size=\"0.1 -0.1 0.1\"/>"),
       "link 'a': box size '0.1 -0.1 0.1' has to be positive"},
      {"ZeroBox", oneShape("<box size=\"0.1 0 0.1\"/>"), "link 'a': box size '0.1 0 0.1' has to be positive"},
      {"FlatBox", oneShape("<box size=\"0.1 0.1\"/>"), "link 'a': box size '0.1 0.1' has to be 3 number(s)"},
      {"BoxWithoutSize", oneShape("<box/>"), "link 'a': <box> has no size"},
      {"NanSphere", oneShape("<sphere radius=\"nan\"/>"), "link 'a': sphere radius 'nan'"},
      {"InfiniteSphere", oneShape("<sphere radius=\"inf\"/>"), "link 'a': sphere radius 'inf'"},
      {"NegativeSphere", oneShape("<sphere radius=\"-1\"/>"),
       "link 'a': sphere radius '-1' has to be positive"},
      {"ZeroCylinder", oneShape("<cylinder radius=\"0\" length=\"1\"/>"), "link 'a': cylinder radius '0'"},
      {"CylinderWithoutLength", oneShape("<cylinder radius=\"1\"/>"), "link 'a': <cylinder> has no length"},
      {"UnknownShape", oneShape("<capsule radius=\"1\" length=\"1\"/>"), "link 'a': unknown shape <capsule>"},
      {"NoShape", oneShape(""), "link 'a': <collision> has no shape"},
      {"NoGeometry", robot("<link name=\"a\"><collision/></link>"), "link 'a': <collision> has no shape"},
      {"TwoShapes", oneShape("<sphere radius=\"1\"/><sphere radius=\"1\"/>"),
       "link 'a': <geometry> has more than one shape"},
      {"MeshWithoutFile", oneShape("<mesh/>"), "link 'a': <mesh> has no filename"},
      {"NanShapeOrigin", oneShape("<sphere radius=\"1\"/>", "<origin xyz=\"nan 0 0\"/>"),
       "link 'a': origin xyz 'nan 0 0'"},
      // Only urdfdom trips over this one: it splits at blanks alone, and drops the shape.
      {"DroppedShape", oneShape("<box size=\"1&#x9;1&#x9;1\"/>"),
       "link 'a': 1 collision shapes are declared but urdfdom read only 0"},
  };
}

class UrdfValidation : public testing::TestWithParam<BadUrdf> {};

TEST_P(UrdfValidation, NamesFileElementAndValueOnOneLine) {
  const TemporaryFolder folder;
  const std::string file = folder.write("bad.urdf", GetParam().text);
  try {
    loadUrdf(file);
    ADD_FAILURE() << "was accepted";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_THAT(what, StartsWith(file + ": "));
    EXPECT_THAT(what, HasSubstr(GetParam().problem));
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  }
}

const auto kNameOf = [](const auto& instance) { return instance.param.name; };
INSTANTIATE_TEST_SUITE_P(Trees, UrdfValidation, testing::ValuesIn(badTrees()), kNameOf);
INSTANTIATE_TEST_SUITE_P(Joints, UrdfValidation, testing::ValuesIn(badJoints()), kNameOf);
INSTANTIATE_TEST_SUITE_P(Shapes, UrdfValidation, testing::ValuesIn(badShapes()), kNameOf);

TEST(UrdfFile, MissingOrAFolderIsAnError) {
  const TemporaryFolder folder;
  for (const std::string& file : {folder.path() + "/nothing.urdf", folder.path(), std::string()}) {
    try {
      loadUrdf(file);
      ADD_FAILURE() << file << " was accepted";
    } catch (const InputError& error) {
      EXPECT_EQ(error.what(), file + ": no such file");
    }
  }
}

// A URDF of any length cut anywhere is an error or loads; it never crashes and never loses a shape.
TEST(UrdfFile, CutAnywhereIsAnErrorAndNoCrash) {
  const std::string whole = twoLinks("revolute", kGoodLimit);
  const TemporaryFolder folder;
  for (std::size_t length = 0; length < whole.size(); ++length)
    EXPECT_THROW(loadUrdf(folder.write("cut.urdf", whole.substr(0, length))), InputError) << length;
  EXPECT_NO_THROW(loadUrdf(folder.write("whole.urdf", whole)));
}

}  // namespace
}  // namespace b4p
