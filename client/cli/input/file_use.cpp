// What is said of files that came to the wrong place, or are not there.
#include <algorithm>
#include <filesystem>
#include <span>
#include <string_view>
#include <system_error>
#include <vector>

#include "base/near_names.h"
#include "client/cli/input/file_kind.h"
#include "gonio/base/shown.h"

namespace gonio::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNeighbours = 2000;  // files of a folder that are looked at

struct Described {
  const char* what;
  const char* use;  // FILE stands for its name
};

Described described(FileKind kind) {
  switch (kind) {
    case FileKind::material_json:
      return {"a material's JSON",
              "it is for gonio evaluate --material FILE, gonio render --material FILE"};
    case FileKind::scene_json:
      return {"a scene's JSON", "it is for gonio select --scene FILE"};
    case FileKind::merl:
      return {"a measured table (MERL)",
              "it is for gonio evaluate --material FILE, gonio fit --data FILE"};
    case FileKind::rgl:
      return {"measurements of the RGL database",
              "it is for gonio fit --data FILE, gonio compare --reference FILE"};
    case FileKind::cornell:
      return {"a goniometer's text (Cornell)",
              "it is for gonio fit --data FILE, gonio compare --reference FILE"};
    case FileKind::alta:
      return {"measurements as ALTA's text",
              "it is for gonio fit --data FILE, gonio compare --reference FILE"};
    case FileKind::zemax:
      return {"a Zemax BSDF text",
              "nothing takes it yet: write its values as CSV (theta_i,phi_i,theta_o,phi_o,f_0) for "
              "gonio fit --data"};
    case FileKind::npy:
      return {
          "a NumPy array",
          "it is for gonio evaluate --pairs FILE (N x 6), gonio fit --data FILE (N x 7 and more)"};
    case FileKind::csv_values:
      return {"directions and values as CSV",
              "it is for gonio fit --data FILE, gonio compare --reference FILE"};
    case FileKind::csv_pairs:
      return {"directions as CSV", "it is for gonio evaluate --pairs FILE"};
    case FileKind::picture:
      return {"a picture", "it is for gonio render --light FILE, if it is a map as .exr or .pfm"};
    case FileKind::spreadsheet:
      return {"a spreadsheet or a ZIP archive",
              "nothing takes it: save it as CSV for gonio fit --data or gonio evaluate --pairs"};
    case FileKind::compressed:
      return {"a compressed file", "nothing takes it: unpack it first"};
    case FileKind::other_json:
      return {"JSON of something else", "nothing takes it"};
    case FileKind::unknown:
      break;
  }
  return {"of a kind that is not known", "nothing takes it"};
}

}  // namespace

std::string description_of(FileKind kind) { return described(kind).what; }

std::string use_of(FileKind kind, const std::string& file) {
  std::string text = described(kind).use;
  const std::string name = shown(file, kQuotedLength);
  for (std::size_t at = text.find("FILE"); at != std::string::npos; at = text.find("FILE", at)) {
    text.replace(at, 4, name);
    at += name.size();
  }
  return text;
}

Error wrong_kind(const std::string& option, const std::string& file, FileKind kind,
                 const std::string& wanted) {
  Error error = bad_value(option, "\"" + file + "\", " + description_of(kind), wanted);
  error.message = shown(file, kQuotedLength) + " is " + description_of(kind) + ", not " + wanted +
                  "; " + use_of(kind, file);
  return error;
}

std::string near_files(const std::string& file) {
  const fs::path path(file);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code failed;
  std::vector<std::string> names;
  for (fs::directory_iterator entry(folder, failed), end;
       !failed && entry != end && names.size() < kMostNeighbours; entry.increment(failed)) {
    std::error_code ignored;
    if (entry->is_regular_file(ignored)) names.push_back(entry->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return did_you_mean(path.filename().string(), std::span<const std::string>(names));
}

Error or_near_file(Error error, const std::string& file) {
  const std::string hint = error.code == ErrorCode::not_found ? near_files(file) : std::string();
  if (error.message.find(hint) == std::string::npos) error.message += hint;
  return error;
}

}  // namespace gonio::cli
