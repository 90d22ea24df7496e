// SPDX-License-Identifier: BSD-3-Clause
#include "experiments/output_file.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "robots/input_error.h"

namespace b4p {

namespace fs = std::filesystem;

namespace {

std::string temporaryBeside(const std::string& file) { return file + ".part" + std::to_string(::getpid()); }

}  // namespace

void writeFile(const std::string& file, const std::string& content) {
  const std::string temporary = temporaryBeside(file);
  std::error_code error;
  {
    std::ofstream out(temporary, std::ios::binary);
    out << content << std::flush;
    if (!out) {
      fs::remove(temporary, error);
      throw InputError(file, "", "cannot be written");
    }
  }
  fs::rename(temporary, file, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    throw InputError(file, "", "cannot be written (" + reason + ")");
  }
}

void requireWritableFile(const std::string& file) {
  std::error_code error;
  if (fs::is_directory(file, error)) throw InputError(file, "", "cannot be written (is a folder)");
  const std::string temporary = temporaryBeside(file);
  const bool good = static_cast<bool>(std::ofstream(temporary));
  fs::remove(temporary, error);
  if (!good) throw InputError(file, "", "cannot be written");
}

void requireWritableFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw InputError(folder, "", "cannot be made a folder (" + error.message() + ")");
  requireWritableFile((fs::path(folder) / "probe").string());
}

}  // namespace b4p
