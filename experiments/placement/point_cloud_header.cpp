// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/placement/point_cloud_header.h"

#include <algorithm>
#include <map>

namespace b4p {
namespace {

using Words = std::vector<std::string>;

constexpr std::size_t kMostValues = 10000;  ///< of one name, so that rows stay small

NumberFormat plyFormat(const PointFile& file, const std::string& word) {
  static const std::map<std::string, NumberFormat> kFormats{
      {"char", {'I', 1}},  {"int8", {'I', 1}},    {"uchar", {'U', 1}},  {"uint8", {'U', 1}},
      {"short", {'I', 2}}, {"int16", {'I', 2}},   {"ushort", {'U', 2}}, {"uint16", {'U', 2}},
      {"int", {'I', 4}},   {"int32", {'I', 4}},   {"uint", {'U', 4}},   {"uint32", {'U', 4}},
      {"float", {'F', 4}}, {"float32", {'F', 4}}, {"double", {'F', 8}}, {"float64", {'F', 8}}};
  const auto found = kFormats.find(word);
  if (found == kFormats.end()) file.failHere("'" + word + "' is no type of a PLY property");
  return found->second;
}

PointEncoding plyEncoding(const PointFile& file, const std::string& word) {
  if (word == "ascii") return PointEncoding::kText;
  if (word == "binary_little_endian") return PointEncoding::kLittleEndian;
  if (word == "binary_big_endian") return PointEncoding::kBigEndian;
  file.failHere("'" + word + "' is no format of PLY");
}

PointCloudHeader readPly(PointFile& file) {
  PointCloudHeader header;
  bool format = false, vertices = false, after = false;
  for (;;) {
    const Words line = file.next();
    if (line.empty() || line[0] == "comment" || line[0] == "obj_info") continue;
    if (line[0] == "end_header") break;
    if (line[0] == "format" && line.size() >= 2) {
      header.encoding = plyEncoding(file, line[1]);
      format = true;
    } else if (line[0] == "element" && line.size() == 3) {
      if (!vertices && line[1] != "vertex") file.failHere("the first element is not 'vertex'");
      after = vertices;
      if (!vertices) header.points = file.count(line[2]);
      vertices = true;
    } else if (line[0] == "property" && line.size() >= 3 && vertices) {
      if (after) continue;
      if (line[1] == "list") file.failHere("vertices with a list property are not supported");
      header.columns.push_back({line[2], plyFormat(file, line[1])});
    } else {
      file.failHere("'" + line[0] + "' is not understood in a PLY header");
    }
  }
  if (!format) file.fail("", "the PLY header has no format");
  return header;
}

/// Lines of a PCD header that say something of each field.
void readFields(const PointFile& file, const Words& line, std::vector<PointColumn>& columns) {
  if (line[0] == "FIELDS") {
    columns.clear();
    for (std::size_t i = 1; i < line.size(); ++i) columns.push_back({line[i], {}});
    return;
  }
  if (line.size() != columns.size() + 1)
    file.failHere(line[0] + " has " + std::to_string(line.size() - 1) + " values for " +
                  std::to_string(columns.size()) + " fields");
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string& word = line[i + 1];
    if (line[0] == "TYPE") {
      if (word != "I" && word != "U" && word != "F") file.failHere("'" + word + "' is no TYPE of PCD");
      columns[i].format.kind = word[0];
    } else if (line[0] == "SIZE") {
      columns[i].format.bytes = file.count(word);
    } else {
      columns[i].count = file.count(word);
      if (columns[i].count == 0 || columns[i].count > kMostValues)
        file.failHere("'" + word + "' is not a COUNT from 1 to " + std::to_string(kMostValues));
    }
  }
}

PointEncoding pcdEncoding(const PointFile& file, const std::string& word) {
  if (word == "ascii") return PointEncoding::kText;
  if (word == "binary") return PointEncoding::kLittleEndian;
  if (word == "binary_compressed")
    file.failHere("DATA binary_compressed is not supported; write the file as binary or ascii");
  file.failHere("'" + word + "' is no DATA of PCD");
}

void requireFormats(const PointFile& file, const std::vector<PointColumn>& columns) {
  for (const PointColumn& column : columns) {
    const auto& [kind, bytes] = column.format;
    const bool whole = bytes == 1 || bytes == 2;
    if (!(bytes == 4 || bytes == 8 || (whole && kind != 'F')))
      file.fail("", "field '" + column.name + "' of TYPE " + kind + " has SIZE " + std::to_string(bytes));
  }
}

PointCloudHeader readPcd(PointFile& file, Words line) {
  PointCloudHeader header;
  std::map<std::string, bool> given;
  for (;; line = file.next()) {
    if (line.empty() || line[0][0] == '#') continue;
    const std::string key = line[0];
    given[key] = true;
    if (key == "DATA" && line.size() == 2) {
      header.encoding = pcdEncoding(file, line[1]);
      break;
    }
    if (key == "FIELDS" || key == "SIZE" || key == "TYPE" || key == "COUNT") {
      readFields(file, line, header.columns);
    } else if (key == "POINTS" && line.size() == 2) {
      header.points = file.count(line[1]);
    } else if (key != "VERSION" && key != "WIDTH" && key != "HEIGHT" && key != "VIEWPOINT") {
      file.failHere("'" + key + "' is not understood in a PCD header");
    }
  }
  if (!given["POINTS"]) file.fail("", "the PCD header has no POINTS");
  for (const char* key : {"SIZE", "TYPE"})
    if (header.encoding != PointEncoding::kText && !given[key])
      file.fail("", std::string("the PCD header has no ") + key);
  if (given["SIZE"] && given["TYPE"]) requireFormats(file, header.columns);
  return header;
}

}  // namespace

PointCloudHeader readPointCloudHeader(PointFile& file) {
  Words first = file.next();
  while (!first.empty() && first[0][0] == '#') first = file.next();
  const bool ply = first == Words{"ply"};
  if (!ply && (first.empty() || (first[0] != "VERSION" && first[0] != "FIELDS")))
    file.failHere("the file begins neither as PLY nor as PCD");
  PointCloudHeader header = ply ? readPly(file) : readPcd(file, first);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const auto found = std::find_if(header.columns.begin(), header.columns.end(),
                                    [&](const PointColumn& column) { return column.name == name; });
    if (found == header.columns.end()) file.fail("", "points have no " + name);
    if (found->count != 1) file.fail("", "points have several values of " + name);
    header.xyz.at(axis) = static_cast<std::size_t>(found - header.columns.begin());
  }
  if (header.points == 0) file.fail("", "holds no points");
  return header;
}

}  // namespace b4p
