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

/// The regular file to replace, or the place of a new one. Renaming onto a link, device or pipe would remove
/// it.
std::string destination(const std::string& file) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  const bool link = fs::is_symlink(fs::symlink_status(file, error));
  if (fs::is_directory(status)) throw InputError(file, "", "cannot be written (is a folder)");
  if (link && !fs::exists(status)) throw InputError(file, "", "cannot be written (is a link to nothing)");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw InputError(file, "", "cannot be written (is not a regular file)");
  if (!link) return file;
  const fs::path target = fs::canonical(file, error);
  if (error) throw InputError(file, "", "cannot be written (" + error.message() + ")");
  return target.string();
}

}  // namespace

void writeFile(const std::string& file, const std::string& content) {
  const std::string target = destination(file);
  const std::string temporary = temporaryBeside(target);
  std::error_code error;
  {
    std::ofstream out(temporary, std::ios::binary);
    out << content << std::flush;
    if (!out) {
      fs::remove(temporary, error);
      throw InputError(file, "", "cannot be written");
    }
  }
  fs::rename(temporary, target, error);
  if (error) {
    const std::string reason = error.message();
    fs::remove(temporary, error);
    throw InputError(file, "", "cannot be written (" + reason + ")");
  }
}

void requireWritableFile(const std::string& file) {
  std::error_code error;
  const std::string temporary = temporaryBeside(destination(file));
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
