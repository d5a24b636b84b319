#include "client/cli/input/file_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "gonio/measured/table.h"

namespace gonio::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kBeginning = 4096;

bool begins_with(std::string_view text, std::string_view start) {
  return text.substr(0, start.size()) == start;
}

bool holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// Formats that say what they are in their first bytes.
std::optional<FileKind> by_magic(std::string_view bytes) {
  struct Magic {
    std::string_view start;
    FileKind kind;
  };
  constexpr Magic kMagics[] = {{"\x93NUMPY", FileKind::npy},
                               {"tensor_file", FileKind::rgl},
                               {"\x89PNG", FileKind::picture},
                               {"\x76\x2f\x31\x01", FileKind::picture},
                               {"PF\n", FileKind::picture},
                               {"Pf\n", FileKind::picture},
                               {"PK\x03\x04", FileKind::spreadsheet},
                               {"\xd0\xcf\x11\xe0", FileKind::spreadsheet},
                               {"\x1f\x8b", FileKind::compressed},
                               {"\xfd"
                                "7zXZ",
                                FileKind::compressed},
                               {"BZh", FileKind::compressed}};
  for (const Magic& magic : kMagics) {
    if (begins_with(bytes, magic.start)) return magic.kind;
  }
  return std::nullopt;
}

FileKind kind_of_json(std::string_view text) {
  const auto has = [&](const char* key) { return holds(text, std::string("\"") + key + "\""); };
  if (has("tolerance") || has("histogram") || has("theta_i")) return FileKind::scene_json;
  const bool material = has("model") || has("specular") || has("diffuse") || has("name");
  return material ? FileKind::material_json : FileKind::other_json;
}

FileKind kind_of_table(std::string_view first_line) {
  const std::string header = lower(first_line);
  const bool pairs = holds(header, "wi_x") || holds(header, "theta_i");
  if (!pairs) return FileKind::unknown;
  return holds(header, "f_0") ? FileKind::csv_values : FileKind::csv_pairs;
}

bool is_text(std::string_view bytes) {
  return std::none_of(bytes.begin(), bytes.end(), [](unsigned char c) {
    return c < ' ' && c != '\n' && c != '\r' && c != '\t' && c != '\f';
  });
}

FileKind kind_of_text(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string_view::npos) return FileKind::unknown;
  text.remove_prefix(start);
  if (text.front() == '{') return kind_of_json(text);
  const std::string_view first = text.substr(0, text.find_first_of("\r\n"));
  const std::string all = lower(text);
  if (holds(all, "#dim") || holds(all, "#param_in")) return FileKind::alta;
  if (holds(all, "angleofincidence") || holds(all, "scattertype")) return FileKind::zemax;
  if (const FileKind table = kind_of_table(first); table != FileKind::unknown) return table;
  // Its numbers alone say nothing; the database's files begin with where they come from.
  return text.front() == '#' && holds(all, "cornell") ? FileKind::cornell : FileKind::unknown;
}

}  // namespace

FileKind kind_of_content(const std::string& beginning, std::uint64_t size) {
  if (const auto magic = by_magic(beginning)) return *magic;
  if (size == MeasuredTable::kFileBytes) return FileKind::merl;
  std::string_view text = beginning;
  if (begins_with(text, "\xEF\xBB\xBF")) text.remove_prefix(3);
  return is_text(text) ? kind_of_text(text) : FileKind::unknown;
}

std::optional<FileKind> kind_of_file(const std::string& file) {
  std::error_code failed;
  if (!fs::is_regular_file(file, failed)) return std::nullopt;
  const std::uint64_t size = fs::file_size(file, failed);
  std::ifstream in(file, std::ios::binary);
  if (failed || !in) return std::nullopt;
  std::string beginning(kBeginning, '\0');
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  return kind_of_content(beginning, size);
}

std::string extension_of(const std::string& file) {
  return lower(fs::path(file).extension().string());
}

bool holds_pairs(const std::string& file) {
  constexpr std::array<std::string_view, 6> kExtensions{".brdf", ".bsdf", ".dat",
                                                        ".alta", ".csv",  ".npy"};
  switch (kind_of_file(file).value_or(FileKind::unknown)) {
    case FileKind::rgl:
    case FileKind::cornell:
    case FileKind::alta:
    case FileKind::npy:
    case FileKind::csv_values:
      return true;
    case FileKind::material_json:
    case FileKind::merl:
      return false;
    default:
      break;
  }
  const std::string extension = extension_of(file);
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

}  // namespace gonio::cli
