// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace b4p {

/// Replaces a file's content at once: whoever reads it sees the old or the new content, never a part. A
/// symbolic link stays, and the file that it leads to is replaced. Devices, pipes and other things that are
/// no regular files are left alone.
/// @throws InputError when it cannot be written
void writeFile(const std::string& file, const std::string& content);

/// Makes sure, by trying, that writeFile() can write there, without leaving anything behind.
/// @throws InputError
void requireWritableFile(const std::string& file);

/// Makes a folder where there is none, and makes sure that files can be written into it.
/// @throws InputError
void requireWritableFolder(const std::string& folder);

}  // namespace b4p
