// What is said of files that came to the wrong place, or are not there.
#include <algorithm>
#include <array>
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

constexpr const char* kForFits = "it is for gonio fit --data FILE, gonio compare --reference FILE";

struct Described {
  FileKind kind;
  const char* what;
  const char* use;  // FILE stands for its name
};

constexpr std::array kDescribed{
    Described{FileKind::material_json, "a material's JSON",
              "it is for gonio evaluate --material FILE, gonio render --material FILE"},
    Described{FileKind::scene_json, "a scene's JSON", "it is for gonio select --scene FILE"},
    Described{FileKind::merl, "a measured table (MERL)",
              "it is for gonio evaluate --material FILE, gonio fit --data FILE"},
    Described{FileKind::rgl, "measurements of the RGL database", kForFits},
    Described{FileKind::cornell, "a goniometer's text (Cornell)", kForFits},
    Described{FileKind::alta, "measurements as ALTA's text", kForFits},
    Described{FileKind::zemax, "a Zemax BSDF text",
              "nothing takes it yet: write its values as CSV (theta_i,phi_i,theta_o,phi_o,f_0) for "
              "gonio fit --data"},
    Described{FileKind::npy, "a NumPy array",
              "it is for gonio evaluate --pairs FILE (N x 6), gonio fit --data FILE (N x 7 and "
              "more)"},
    Described{FileKind::csv_values, "directions and values as CSV", kForFits},
    Described{FileKind::csv_pairs, "directions as CSV", "it is for gonio evaluate --pairs FILE"},
    Described{FileKind::picture, "a picture",
              "it is for gonio render --light FILE, if it is a map as .exr or .pfm"},
    Described{FileKind::spreadsheet, "a spreadsheet or a ZIP archive",
              "nothing takes it: save it as CSV for gonio fit --data or gonio evaluate --pairs"},
    Described{FileKind::compressed, "a compressed file", "nothing takes it: unpack it first"},
    Described{FileKind::other_json, "JSON of something else", "nothing takes it"},
    Described{FileKind::unknown, "of a kind that is not known", "nothing takes it"}};

const Described& described(FileKind kind) {
  const auto* const found = std::find_if(kDescribed.begin(), kDescribed.end() - 1,
                                         [&](const Described& one) { return one.kind == kind; });
  return *found;  // the last where none is
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
