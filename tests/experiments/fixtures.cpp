// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/fixtures.h"

#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace b4p::test {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder() {
  std::string name = (fs::temp_directory_path() / "b4p_test_XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code error;
  fs::remove_all(path_, error);
}

std::vector<std::string> TemporaryFolder::files() const {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(path_))
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), path_).string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string readFile(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void writeText(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto found = text.find(from);
  EXPECT_NE(found, std::string::npos) << from;
  EXPECT_EQ(text.find(from, found + 1), std::string::npos) << from << " stands there twice";
  return text.replace(found, from.size(), to);
}

SceneCopy::SceneCopy(const std::vector<Change>& changes, const std::string& changed_file) {
  for (const char* name : {"easy.yaml", "planar.yaml", "planar.urdf"}) {
    std::string text = readFile(std::string(TEST_DATA) + "/" + name);
    if (name == changed_file)
      for (const auto& [from, to] : changes) text = replaced(text, from, to);
    writeText(folder_ / name, text);
  }
}

Experiment benchmarkOf(const SceneCopy& copy, int runs) {
  Experiment experiment;
  experiment.file = experiment.name = "test";
  experiment.runs = runs;
  experiment.time_limit_s = 20.0;
  experiment.scenes = {copy.scene()};
  return experiment;
}

int CommandRun::errorLines() const { return static_cast<int>(std::count(err.begin(), err.end(), '\n')); }

CommandRun runB4p(const std::string& arguments, const std::string& pid_file) {
  const TemporaryFolder folder;
  const std::string command = std::string("cd ") + folder.path() + " && mkdir work && cd work && " +
                              (pid_file.empty() ? "" : "echo $$ > " + pid_file + " && ") + "exec '" +
                              B4P_COMMAND + "' " + arguments + " > ../out 2> ../err < /dev/null";
  const int status = std::system(command.c_str());
  CommandRun run;
  run.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  run.out = readFile(folder / "out");
  run.err = readFile(folder / "err");
  return run;
}

}  // namespace b4p::test
