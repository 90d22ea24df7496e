// SPDX-License-Identifier: BSD-3-Clause
// Promises: only regular files are replaced, links are written through, nothing is left behind.
#include "experiments/output_file.h"

#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "robots/input_error.h"
#include "verification/gantry.h"

namespace b4p {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class OutputFileTest : public testing::Test {
 protected:
  OutputFileTest() { fs::create_directories(folder_); }
  ~OutputFileTest() override { fs::remove_all(folder_); }

  std::string in(const std::string& name) const { return (folder_ / name).string(); }
  static std::string content(const std::string& file) {
    std::stringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }
  std::ptrdiff_t entries() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
  static void expectRefused(const std::string& file, const std::string& reason) {
    for (const bool writes : {false, true}) try {
        writes ? writeFile(file, "new") : requireWritableFile(file);
        ADD_FAILURE() << file << " accepted";
      } catch (const InputError& e) {
        EXPECT_THAT(e.what(), StartsWith(file + ": "));
        EXPECT_THAT(e.what(), HasSubstr(reason));
      }
  }

  fs::path folder_ = test::temporaryFile("output");
};

TEST_F(OutputFileTest, ReplacesARegularFile) {
  for (const char* text : {"old", "new"}) {
    requireWritableFile(in("file"));
    writeFile(in("file"), text);
    EXPECT_EQ(content(in("file")), text);
  }
  EXPECT_EQ(entries(), 1);
}

TEST_F(OutputFileTest, AskingLeavesNothingBehind) {
  requireWritableFile(in("file"));
  EXPECT_EQ(entries(), 0);
}

TEST_F(OutputFileTest, PipesAndDevicesAreRefusedAndStay) {
  ASSERT_EQ(mkfifo(in("pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", in("link_to_pipe"));
  expectRefused(in("pipe"), "is not a regular file");
  expectRefused(in("link_to_pipe"), "is not a regular file");
  EXPECT_TRUE(fs::is_fifo(in("pipe")));
  fs::create_symlink("/dev/null", in("link_to_null"));
  expectRefused(in("link_to_null"), "is not a regular file");
  EXPECT_TRUE(fs::is_symlink(in("link_to_null")));
  EXPECT_EQ(entries(), 3);
}

TEST_F(OutputFileTest, FoldersAndLinksToNothingAreRefused) {
  expectRefused(folder_.string(), "is a folder");
  fs::create_symlink("missing", in("link"));
  expectRefused(in("link"), "is a link to nothing");
  EXPECT_TRUE(fs::is_symlink(in("link")));
  expectRefused("/nowhere/at/all", "cannot be written");
}

TEST_F(OutputFileTest, ALinkToAFileIsWrittenThrough) {
  fs::create_directory(folder_ / "deep");
  writeFile(in("deep/file"), "old");
  fs::create_symlink("deep/file", in("link"));
  fs::create_symlink("link", in("link_to_link"));
  requireWritableFile(in("link_to_link"));
  writeFile(in("link_to_link"), "new");
  EXPECT_EQ(content(in("deep/file")), "new");
  EXPECT_TRUE(fs::is_symlink(in("link")));
  EXPECT_TRUE(fs::is_symlink(in("link_to_link")));
  EXPECT_EQ(entries(), 3);
}

TEST_F(OutputFileTest, AWritableFolderIsMadeWhereItIsMissing) {
  for (int twice = 0; twice < 2; ++twice) {
    requireWritableFolder(in("made/deep/down"));
    EXPECT_TRUE(fs::is_empty(in("made/deep/down")));
  }
  writeFile(in("file"), "");
  EXPECT_THROW(requireWritableFolder(in("file/below_a_file")), InputError);
  EXPECT_THROW(requireWritableFolder(in("file")), InputError);
  EXPECT_THROW(requireWritableFolder("/proc/no_such_place"), InputError);
}

}  // namespace
}  // namespace b4p
