// What a file is, by its content, and which commands take it: for files that come to the wrong
// place, or under another name. Thread safety: functions without state.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "gonio/base/result.h"

namespace gonio::cli {

enum class FileKind : std::uint8_t {
  material_json,  // a material as people write it
  scene_json,     // of `gonio select`
  other_json,
  merl,     // a measured table, MERL's .binary
  rgl,      // the RGL database's tensor file
  cornell,  // a goniometer's text: wavelengths, then angles and values
  alta,     // ALTA's text
  zemax,    // Zemax's and OpticStudio's .bsdf
  npy,
  csv_values,  // directions or angles, and values
  csv_pairs,   // directions or angles alone
  picture,     // PNG, OpenEXR, PFM
  spreadsheet,
  compressed,
  unknown,
};

// None where it cannot be read: not there, a folder, not ours. A pipe or a device is not touched.
std::optional<FileKind> kind_of_file(const std::string& file);

// The kind of a content by its beginning, of 4096 bytes or all of it, and by its size.
FileKind kind_of_content(const std::string& beginning, std::uint64_t size);

// "a measured table (MERL)"
std::string description_of(FileKind kind);
// "it is for gonio evaluate --material FILE"; of what nothing takes, what to do.
std::string use_of(FileKind kind, const std::string& file);

// "FILE is a goniometer's text (Cornell), not a material; it is for gonio fit --data FILE".
// `wanted` says what was expected: "a material".
Error wrong_kind(const std::string& option, const std::string& file, FileKind kind,
                 const std::string& wanted);

// Whether a file holds measured pairs, by its content or, where that says nothing, its extension.
bool holds_pairs(const std::string& file);
// A file's extension in lower case: ".binary".
std::string extension_of(const std::string& file);

// "; did you mean \"gold.json\"?", of the files beside the one that is not there, or nothing.
std::string near_files(const std::string& file);
// The same at the end of an error that says that there is no such file.
Error or_near_file(Error error, const std::string& file);

}  // namespace gonio::cli
